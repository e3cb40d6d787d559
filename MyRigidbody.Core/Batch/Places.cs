#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Which body is in which place. Places are without gaps: the last body takes that of one who leaves. A body's number
    /// stays, and the number of one who has left is given to the next who comes.
    /// </summary>
    internal sealed class Places
    {
        // of an id the place, or where it is free −2 − the next free id; of a place the id
        private int[] _places = Array.Empty<int>(), _ids = Array.Empty<int>();
        private int _free = -1;

        public int Count { get; private set; }

        public int EndOfIds { get; private set; }

        public void Reserve(int capacity)
        {
            Array.Resize(ref _places, capacity);
            Array.Resize(ref _ids, capacity);
        }

        /// <summary>A body comes and gets the place after the last.</summary>
        public int Add()
        {
            int id = _free;
            if (id < 0)
                id = EndOfIds++;
            else
                _free = -2 - _places[id];

            _places[id] = Count;
            _ids[Count++] = id;
            return id;
        }

        public void Remove(int id)
        {
            int place = Of(id), last = _ids[--Count];
            _ids[place] = last;
            _places[last] = place;
            _places[id] = -2 - _free;
            _free = id;
        }

        public int IdAt(int place) => _ids[place];

        public int Of(int id) =>
            (uint)id < (uint)EndOfIds && _places[id] >= 0 ? _places[id] : throw Guard.Refused(nameof(id), id, "must be the number of a body that is there");
    }
}
#endif

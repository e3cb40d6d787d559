namespace RigidBodyDynamics.Engine
{
    /// <summary>The scenes of a project.</summary>
    internal interface IScenes
    {
        /// <summary>Where the project has a scene of that name.</summary>
        string PathOf(string scene);

        /// <summary>A path of the project, which begins with Assets.</summary>
        string InProject(string path);

        /// <summary>Makes the objects of a scene file, then wakes them.</summary>
        void Load(string path);
    }
}

namespace RigidBodyDynamics.Engine
{
    /// <summary>The scenes of a project.</summary>
    internal interface IScenes
    {
        /// <summary>The path of the scene with that name in the project.</summary>
        string PathOf(string scene);

        /// <summary>A path of the project, which begins with Assets.</summary>
        string InProject(string path);

        /// <summary>Creates the objects of a scene file, then wakes them.</summary>
        void Load(string path);
    }
}

using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Names that Unity has and the stand-in lacks.</summary>
internal static class UnityNames
{
    private static readonly HashSet<string> Types =
    [
        "Text", "Image", "Button", "Slider", "Toggle", "InputField", "Canvas", "RectTransform", "TextMeshProUGUI", "TextMeshPro", "TMP_Text", "TextMesh",
        "LineRenderer", "TrailRenderer", "ParticleSystem", "AudioSource", "AudioClip", "Animator", "Animation", "SkinnedMeshRenderer", "Shader", "Texture",
        "Texture2D", "Sprite", "Ray", "Plane", "RaycastHit", "LayerMask", "AnimationCurve", "Gradient", "Color32", "ColorUtility", "Vector2Int", "Vector3Int",
        "ScriptableObject", "Resources", "PlayerPrefs", "QualitySettings", "Cursor", "CursorLockMode", "RenderSettings", "SystemInfo", "GeometryUtility",
        "UnityEvent", "EditorGUILayout", "Handles", "Undo", "EditorApplication", "Profiler", "SceneManager", "JsonUtility",
        "InputAction", "Keyboard", "Key", "float2", "float3", "float4", "float3x3", "float4x4", "quaternion", "math", "SphereCollider", "CapsuleCollider", "MeshCollider",
        "GUIUtility", "GUIText", "ContextMenuItemAttribute", "SelectionBase", "SelectionBaseAttribute", "HelpURL", "CreateAssetMenu", "TextAsset", "GUIStyleState", "FontStyle", "TextAnchor",
    ];

    /// <summary>Members, listed in Unity's manual, that the stand-in lacks of types that it has.</summary>
    private static readonly HashSet<string> Members =
    [
        "Mathf.PerlinNoise", "Mathf.PerlinNoise1D", "Mathf.CorrelatedColorTemperatureToRGB", "Mathf.FloatToHalf", "Mathf.HalfToFloat",
        "Matrix4x4.Perspective", "Matrix4x4.Ortho", "Matrix4x4.LookAt", "Matrix4x4.Frustum", "Matrix4x4.TransformPlane", "Matrix4x4.ValidTRS", "Matrix4x4.decomposeProjection",
        "Matrix4x4.Inverse3DAffine", "Vector3.OrthoNormalize", "Vector3.RotateTowards", "Vector3.Slerp", "Vector3.SlerpUnclamped", "Vector3.SmoothDamp",
        "Vector2.SmoothDamp", "Vector2.MoveTowards", "Vector2.Perpendicular", "Vector2.Reflect", "Vector2.SignedAngle", "Vector4.MoveTowards", "Vector4.Project",
        "Transform.DetachChildren", "Transform.Find", "Transform.IsChildOf", "Transform.SetAsFirstSibling", "Transform.SetAsLastSibling", "Transform.SetSiblingIndex", "Transform.GetSiblingIndex", "Transform.SetLocalPositionAndRotation",
        "Time.captureDeltaTime", "Time.renderedFrameCount", "Time.maximumParticleDeltaTime", "Time.realtimeSinceStartupAsDouble", "Time.unscaledTimeAsDouble",
        "Input.touchCount", "Input.GetTouch", "Input.GetButton", "Input.GetButtonDown", "Input.GetButtonUp", "Input.mouseScrollDelta", "Input.touches", "Input.acceleration",
        "Debug.unityLogger", "Debug.LogAssertion", "Debug.developerConsoleVisible",
        "Mesh.uv", "Mesh.colors", "Mesh.tangents", "Mesh.SetVertices", "Mesh.GetTriangles", "Mesh.SetTriangles", "Mesh.subMeshCount", "Mesh.Clear", "Mesh.GetIndices", "Mesh.normals",
        "Material.SetColor", "Material.SetFloat", "Material.mainTexture", "Material.shader", "Renderer.bounds", "Renderer.materials", "Collider.bounds", "Collider.isTrigger", "Collider.material",
        "GUI.Box", "GUI.Button", "GUI.TextField", "GUI.HorizontalSlider", "GUI.Toggle", "GUI.contentColor", "GUI.backgroundColor", "GUI.Window", "GUI.depth", "GUI.enabled", "GUISkin.label", "GUISkin.button", "GUIStyle.fontSize", "GUIStyle.normal",
        "GUILayout.BeginVertical", "GUILayout.EndVertical", "GUILayout.Height", "GUILayout.HorizontalSlider", "GUILayout.TextField", "GUILayout.Box", "GUILayout.FlexibleSpace",
        "Gizmos.DrawLine", "Gizmos.DrawWireCube", "Gizmos.DrawWireSphere", "Gizmos.DrawCube", "Gizmos.matrix", "Gizmos.DrawMesh",
        "GameObject.SendMessageUpwards", "GameObject.BroadcastMessage", "GameObject.FindGameObjectsWithTag", "GameObject.activeSelf", "Object.Instantiate", "Screen.dpi", "Screen.SetResolution", "Screen.fullScreen",
        "Camera.ScreenToWorldPoint", "Camera.ScreenPointToRay", "Camera.backgroundColor", "Camera.orthographic", "Color.HSVToRGB", "Color.linear", "Color.gamma",
    ];

    /// <summary>The name, if the error is that the stand-in lacks it; null if it is anything else.</summary>
    public static string? NotHere(Diagnostic error, CSharpCompilation compilation)
    {
        SyntaxNode? node = error.Location.SourceTree?.GetRoot().FindNode(error.Location.SourceSpan, getInnermostNodeForTie: true);
        string name = (node as SimpleNameSyntax)?.Identifier.ValueText ?? string.Empty;
        if (error.Id is "CS0246" or "CS0103")
            return Types.Contains(name) ? name : null;
        if (error.Id is not ("CS0117" or "CS1061") || node?.Parent is not MemberAccessExpressionSyntax access)
            return null;

        SemanticModel model = compilation.GetSemanticModel(error.Location.SourceTree!);
        ITypeSymbol? type = model.GetTypeInfo(access.Expression).Type ?? model.GetSymbolInfo(access.Expression).Symbol as ITypeSymbol;
        for (; type != null; type = type.BaseType)
        {
            if (Members.Contains(type.Name + "." + name))
                return type.Name + "." + name;
        }

        return null;
    }
}

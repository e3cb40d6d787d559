using System;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Editing
{
    /// <summary>The inspector of a MyRigidbody: the catalogue as a menu, errors in its settings, and the parts of its motion.</summary>
    [CustomEditor(typeof(MyRigidbody))]
    [CanEditMultipleObjects]
    public sealed class MyRigidbodyEditor : Editor
    {
        private static readonly string[] Names = Rules.All.Select(rule => rule.Name).ToArray();

        /// <summary>Draws the inspector.</summary>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            SerializedProperty property = serializedObject.GetIterator();
            for (bool enters = true; property.NextVisible(enters); enters = false)
            {
                if (property.name == "integrator")
                    Menu(property);
                else
                    Field(property);
            }

            serializedObject.ApplyModifiedProperties();
            MyRigidbody body = (MyRigidbody)target;
            if (body.GetComponent<Rigidbody>() != null)
                EditorGUILayout.HelpBox("MyRigidbody and Rigidbody would both move this object; remove one of them.\n同一对象上不能同时有 MyRigidbody 和 Rigidbody，请删去一个。", MessageType.Error);

            if (Application.isPlaying && body.IsReady)
                EditorGUILayout.HelpBox(body.Explain(), MessageType.Info);
        }

        // the script field can be opened, as in every inspector, but not changed
        private static void Field(SerializedProperty property)
        {
            using (new EditorGUI.DisabledScope(property.name == "m_Script"))
                EditorGUILayout.PropertyField(property, true);
        }

        private static void Menu(SerializedProperty integrator)
        {
            int now = Array.IndexOf(Names, integrator.stringValue);
            EditorGUI.BeginChangeCheck();
            int chosen = EditorGUILayout.Popup(new GUIContent(integrator.displayName, integrator.tooltip), now, Names);
            if (EditorGUI.EndChangeCheck() && chosen >= 0)
                integrator.stringValue = Names[chosen];

            if (now >= 0)
                EditorGUILayout.HelpBox(Rules.All[now].About, MessageType.None);
        }
    }
}

using System.Collections;
using System.Collections.Generic;
using UnityEngine;

public class MyRigidbody : MonoBehaviour
{
    public float mass = 1;              // 质量
    public float dt = 0.02f;            // 时间步长
    Vector3 force;                      // 外力
    Vector3 torque;                     // 扭矩
    Vector3 v = Vector3.zero;           // 速度
    Vector3 w = Vector3.zero;           // 角速度
    Matrix4x4 I_ref;                    // 默认状态下的转动惯量

    // Start is called before the first frame update
    void Start()
    {
        Vector3[] vertices = GetComponent<MeshFilter>().mesh.vertices;
        float m = mass / vertices.Length;
        I_ref = Matrix4x4.zero;
        foreach (Vector3 r in vertices)
        {
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    I_ref[i, j] += m * ((i == j ? Vector3.Dot(r, r) : 0) - r[i] * r[j]);
        }
        I_ref[3, 3] = 1;
    }

    // Update is called once per frame
    void Update()
    {
        torque = Vector3.zero;
        if (Input.GetKey(KeyCode.R))
        {
            torque = new Vector3(Mathf.Sin(Time.time), Mathf.Sin(Time.time), Mathf.Sin(Time.time));
        }
        force = Vector3.zero;
        if (Input.GetKey(KeyCode.LeftArrow))
            force += new Vector3(-5, 0, 0);
        if (Input.GetKey(KeyCode.RightArrow))
            force += new Vector3(5, 0, 0);
        if (Input.GetKey(KeyCode.UpArrow))
            force += new Vector3(0, 5, 0);
        if (Input.GetKey(KeyCode.DownArrow))
            force += new Vector3(0, -5, 0);

        // TODO 更新速度

        // TODO 更新角速度

        // TODO 更新位置

        // TODO 更新方向

        // TODO 衰减速度及角速度
    }
}

using UnityEngine;

public class MyRigidbody : MonoBehaviour
{
    public float mass = 1;
    public float dt = 0.02f;
    Vector3 force;
    Vector3 torque;
    Vector3 v;
    Vector3 w;
    Matrix4x4 I_ref;
    #region fields
    #endregion

    void Start()
    {
        Vector3[] vertices = GetComponent<MeshFilter>().mesh.vertices;
        float m = mass / vertices.Length;
        I_ref = Matrix4x4.zero;
        foreach (Vector3 r in vertices)
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    I_ref[i, j] += m * ((i == j ? Vector3.Dot(r, r) : 0) - r[i] * r[j]);
        I_ref[3, 3] = 1;
        #region start
        #endregion
    }

    #region message
    void Update()
    #endregion
    {
        #region given
        torque = Vector3.zero;
        if (Input.GetKey(KeyCode.R)) torque = new Vector3(Mathf.Sin(Time.time), Mathf.Sin(Time.time), Mathf.Sin(Time.time));
        force = Vector3.zero;
        if (Input.GetKey(KeyCode.LeftArrow)) force += new Vector3(-5, 0, 0);
        if (Input.GetKey(KeyCode.RightArrow)) force += new Vector3(5, 0, 0);
        if (Input.GetKey(KeyCode.UpArrow)) force += new Vector3(0, 5, 0);
        if (Input.GetKey(KeyCode.DownArrow)) force += new Vector3(0, -5, 0);
        #endregion

        #region before
        #endregion

        #region step 1
        v += force / mass * dt;
        #endregion

        #region step 2
        Matrix4x4 R = Matrix4x4.Rotate(transform.rotation);
        Matrix4x4 I = R * I_ref * R.transpose;
        w += I.inverse.MultiplyVector(torque) * dt;
        #endregion

        #region between
        #endregion

        #region step 3
        transform.position += v * dt;
        #endregion

        #region step 4
        Quaternion q = transform.rotation;
        Quaternion dq = new Quaternion(w.x * dt / 2, w.y * dt / 2, w.z * dt / 2, 0) * q;
        q.x += dq.x;
        q.y += dq.y;
        q.z += dq.z;
        q.w += dq.w;
        transform.rotation = q.normalized;
        #endregion

        #region step 5
        v *= 0.98f;
        w *= 0.98f;
        #endregion
    }
}

using UnityEngine;

// Unity 自带的刚体，用来和你的 MyRigidbody 比较。按键相同：方向键施加 5 N 的力，R 键施加扭矩 (sin t, sin t, sin t)。
// Unity's own body, to compare yours with. The same keys give the same force and torque.
[RequireComponent(typeof(Rigidbody))]
public class DefaultRigidbody : MonoBehaviour
{
    Rigidbody body;

    void Start()
    {
        body = GetComponent<Rigidbody>();
    }

    // 每个固定步长施力一次；若写在 Update 中，每帧施力一次，力的大小就与帧率有关
    // once in every fixed step; in Update a force would act once a frame, and depend on the frame rate
    void FixedUpdate()
    {
        if (Input.GetKey(KeyCode.R))
        {
            float s = Mathf.Sin(Time.time);
            body.AddTorque(new Vector3(s, s, s));
        }
        if (Input.GetKey(KeyCode.LeftArrow))
            body.AddForce(new Vector3(-5, 0, 0));
        if (Input.GetKey(KeyCode.RightArrow))
            body.AddForce(new Vector3(5, 0, 0));
        if (Input.GetKey(KeyCode.UpArrow))
            body.AddForce(new Vector3(0, 5, 0));
        if (Input.GetKey(KeyCode.DownArrow))
            body.AddForce(new Vector3(0, -5, 0));
    }
}

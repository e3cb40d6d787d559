namespace UnityEngine
{
    // translations, rotations, and conversions between the object's axes and the world's
    public partial class Transform
    {
        public Vector3 right
        {
            get => rotation * Vector3.right;
            set => rotation = Quaternion.FromToRotation(Vector3.right, value);
        }

        public Vector3 up
        {
            get => rotation * Vector3.up;
            set => rotation = Quaternion.FromToRotation(Vector3.up, value);
        }

        public Vector3 forward
        {
            get => rotation * Vector3.forward;
            set => rotation = Quaternion.LookRotation(value);
        }

        /// <summary>Degrees, from 0 to 360.</summary>
        public Vector3 eulerAngles
        {
            get => rotation.eulerAngles;
            set => rotation = Quaternion.Euler(value);
        }

        public Vector3 localEulerAngles
        {
            get => localRotation.eulerAngles;
            set => localRotation = Quaternion.Euler(value);
        }

        public Matrix4x4 localToWorldMatrix
        {
            get
            {
                Matrix4x4 local = Matrix4x4.TRS(localPosition, localRotation, localScale);
                return parent == null ? local : parent.localToWorldMatrix * local;
            }
        }

        public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

        /// <summary>Along the object's own axes.</summary>
        public void Translate(Vector3 translation) => Translate(translation, Space.Self);

        public void Translate(float x, float y, float z) => Translate(new Vector3(x, y, z));

        public void Translate(float x, float y, float z, Space relativeTo) => Translate(new Vector3(x, y, z), relativeTo);

        public void Translate(Vector3 translation, Space relativeTo) =>
            position += relativeTo == Space.World ? translation : TransformDirection(translation);

        public void Translate(Vector3 translation, Transform relativeTo) =>
            position += relativeTo == null ? translation : relativeTo.TransformDirection(translation);

        /// <summary>About the object's own axes, in degrees: z, then x, then y.</summary>
        public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);

        public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle));

        public void Rotate(float xAngle, float yAngle, float zAngle, Space relativeTo) => Rotate(new Vector3(xAngle, yAngle, zAngle), relativeTo);

        public void Rotate(Vector3 eulers, Space relativeTo) => Turn(Quaternion.Euler(eulers), relativeTo);

        public void Rotate(Vector3 axis, float angle) => Rotate(axis, angle, Space.Self);

        public void Rotate(Vector3 axis, float angle, Space relativeTo) => Turn(Quaternion.AngleAxis(angle, axis), relativeTo);

        public void RotateAround(Vector3 point, Vector3 axis, float angle)
        {
            Quaternion turn = Quaternion.AngleAxis(angle, axis);
            position = point + turn * (position - point);
            rotation = turn * rotation;
        }

        public void LookAt(Vector3 worldPosition) => rotation = Quaternion.LookRotation(worldPosition - position);

        public void LookAt(Transform target) => LookAt(target.position);

        public Vector3 TransformDirection(Vector3 direction) => rotation * direction;

        public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

        public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);

        public Vector3 InverseTransformPoint(Vector3 position) => worldToLocalMatrix.MultiplyPoint3x4(position);

        public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);

        public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);

        private void Turn(Quaternion turn, Space relativeTo)
        {
            if (relativeTo == Space.Self)
                localRotation *= turn;
            else
                rotation = turn * rotation;
        }
    }

    /// <summary>The axes of a translation or rotation.</summary>
    public enum Space
    {
        World,
        Self,
    }
}

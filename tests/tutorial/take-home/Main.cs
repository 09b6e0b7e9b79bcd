using System;
using System.Globalization;
using System.Linq;
using UnityEngine;

// As much of Unity as Step.cs and Step3D.cs need.
namespace UnityEngine
{
    public struct Vector2
    {
        public float x, y;
        public Vector2(float x, float y) { this.x = x; this.y = y; }
        public static float Dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
        public static Vector2 operator *(Vector2 a, float d) { return new Vector2(a.x * d, a.y * d); }
        public static Vector2 operator +(Vector2 a, Vector2 b) { return new Vector2(a.x + b.x, a.y + b.y); }
    }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 zero { get { return new Vector3(0f, 0f, 0f); } }
        public float magnitude { get { return (float)Math.Sqrt(x * x + y * y + z * z); } }
        public static float Dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
        public static Vector3 operator *(Vector3 a, float d) { return new Vector3(a.x * d, a.y * d, a.z * d); }
        public static Vector3 operator +(Vector3 a, Vector3 b) { return new Vector3(a.x + b.x, a.y + b.y, a.z + b.z); }
        public static Vector3 operator -(Vector3 a, Vector3 b) { return new Vector3(a.x - b.x, a.y - b.y, a.z - b.z); }
    }

    public static class Mathf
    {
        public static float Min(float a, float b) { return Math.Min(a, b); }
        public static float Max(float a, float b) { return Math.Max(a, b); }
        public static float Abs(float f) { return Math.Abs(f); }
        public static float Sign(float f) { return f >= 0f ? 1f : -1f; }
    }
}

public static class Program
{
    public static void Main()
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        for (string line; (line = Console.ReadLine()) != null; )
        {
            float[] n = line.Split(' ').Select(word => (float)double.Parse(word)).ToArray();
            if (n[0] == 2f) InThePlane(n); else InSpace(n);
        }
    }

    static void InThePlane(float[] n)
    {
        Vector2 position = new Vector2(0f, 0f), velocity = new Vector2(n[1], n[2]);
        Vector2 gravity = new Vector2(n[3], n[4]), normal = new Vector2(n[5], n[6]);
        foreach (float dt in n.Skip(9))
        {
            Sliding.Step(ref position, ref velocity, dt, gravity, normal, n[7], n[8]);
            Console.WriteLine("row {0:R} {1:R} {2:R} {3:R}", position.x, position.y, velocity.x, velocity.y);
        }
    }

    static void InSpace(float[] n)
    {
        Vector3 r = Vector3.zero, v = new Vector3(n[1], n[2], n[3]);
        Vector3 gravity = new Vector3(n[4], n[5], n[6]), normal = new Vector3(n[7], n[8], n[9]);
        foreach (float dt in n.Skip(12))
        {
            Sliding3D.Step(ref r, ref v, dt, gravity, normal, n[10], n[11]);
            Console.WriteLine("row {0:R} {1:R} {2:R} {3:R} {4:R} {5:R}", r.x, r.y, r.z, v.x, v.y, v.z);
        }
    }
}

using System;
using System.Globalization;
using System.Linq;
using UnityEngine;

// As much of Unity as Step.cs needs.
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

    public static class Mathf
    {
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
            Vector2 position = new Vector2(0f, 0f), velocity = new Vector2(n[0], n[1]);
            Vector2 gravity = new Vector2(n[2], n[3]), normal = new Vector2(n[4], n[5]);
            foreach (float dt in n.Skip(8))
            {
                Sliding.Step(ref position, ref velocity, dt, gravity, normal, n[6], n[7]);
                Console.WriteLine("row {0:R} {1:R} {2:R} {3:R}", position.x, position.y, velocity.x, velocity.y);
            }
        }
    }
}

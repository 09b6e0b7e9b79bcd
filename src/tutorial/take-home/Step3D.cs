using UnityEngine;

public static class Sliding3D
{
    /// <summary>Moves a body that slides on a surface by dt seconds.</summary>
    public static void Step(ref Vector3 position, ref Vector3 velocity, float dt,
        Vector3 gravity, Vector3 normal, float muStatic, float muKinetic)
    {
        // 1. Gravity drives along the surface and presses into it.
        Vector3 drive = gravity - normal * Vector3.Dot(gravity, normal);
        float press = Mathf.Max(0f, -Vector3.Dot(gravity, normal));
        float hold = Mathf.Max(muStatic, muKinetic) * press;
        velocity -= normal * Vector3.Dot(velocity, normal);
        float left = dt;
        while (left > 0f)
        {
            // 2. At rest, static friction decides: stay, or set off.
            float speed = velocity.magnitude;
            if (speed == 0f && drive.magnitude <= hold) break;
            // 3. Sliding, friction pulls against the way it slides.
            Vector3 way = speed > 0f ? velocity : drive;
            Vector3 a = drive - way * (muKinetic * press / way.magnitude);
            // 4. If it stops within this part of the step, go only to that instant.
            float t = Mathf.Max(dt / 1000f, 0.02f * speed / a.magnitude);
            t = Mathf.Min(left, t);
            float brake = -Vector3.Dot(a, way) / way.magnitude;
            bool stops = brake > 0f && speed / brake <= t;
            if (stops) t = speed / brake;
            // 5. The way turns: what it is halfway is right for the whole part.
            Vector3 halfway = stops ? way : way + a * (t / 2f);
            a = drive - halfway * (muKinetic * press / halfway.magnitude);
            position += velocity * t + a * (t * t / 2f);
            velocity = stops ? Vector3.zero : velocity + a * t;
            // 6. Go on with what is left of the step.
            left -= t;
        }
    }
}

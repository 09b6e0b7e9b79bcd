using UnityEngine;

public static class Sliding
{
    /// <summary>Moves a body that slides on a surface by dt seconds.</summary>
    public static void Step(ref Vector2 position, ref Vector2 velocity, float dt,
        Vector2 gravity, Vector2 normal, float muStatic, float muKinetic)
    {
        // 1. Gravity drives along the surface and presses into it.
        Vector2 along = new Vector2(normal.y, -normal.x);
        float drive = Vector2.Dot(gravity, along);
        float press = Mathf.Max(0f, -Vector2.Dot(gravity, normal));
        float hold = Mathf.Max(muStatic, muKinetic) * press;
        float speed = Vector2.Dot(velocity, along);
        float moved = 0f;
        float left = dt;
        while (left > 0f)
        {
            // 2. At rest, static friction decides: stay, or set off.
            if (speed == 0f && Mathf.Abs(drive) <= hold) break;
            // 3. Sliding, friction pulls against the way it slides.
            float slip = Mathf.Sign(speed != 0f ? speed : drive);
            float a = drive - slip * muKinetic * press;
            // 4. If it stops within the step, go only to that instant.
            bool stops = slip * a < 0f && -speed / a <= left;
            float t = stops ? -speed / a : left;
            // 5. Along the parabola: exact while the force is constant.
            moved += (speed + 0.5f * a * t) * t;
            speed = stops ? 0f : speed + a * t;
            // 6. Go on with what is left of the step.
            left -= t;
        }
        position += along * moved;
        velocity = along * speed;
    }
}

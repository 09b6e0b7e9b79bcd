#include "CoreMinimal.h"

/** Moves a body that slides on a surface by DeltaTime seconds. */
void Step(FVector2D& Position, FVector2D& Velocity, double DeltaTime,
          const FVector2D& Gravity, const FVector2D& Normal,
          double MuStatic, double MuKinetic)
{
    // 1. Gravity drives along the surface and presses into it.
    const FVector2D Along(Normal.Y, -Normal.X);
    const double Drive = FVector2D::DotProduct(Gravity, Along);
    const double Press = FMath::Max(0.0, -FVector2D::DotProduct(Gravity, Normal));
    const double Hold = FMath::Max(MuStatic, MuKinetic) * Press;
    double Speed = FVector2D::DotProduct(Velocity, Along);
    double Moved = 0.0;
    double Left = DeltaTime;
    while (Left > 0.0)
    {
        // 2. At rest, static friction decides: stay, or set off.
        if (Speed == 0.0 && FMath::Abs(Drive) <= Hold) break;
        // 3. Sliding, friction pulls against the way it slides.
        const double Slip = FMath::Sign(Speed != 0.0 ? Speed : Drive);
        const double A = Drive - Slip * MuKinetic * Press;
        // 4. If it stops within the step, go only to that instant.
        const bool bStops = Slip * A < 0.0 && -Speed / A <= Left;
        const double T = bStops ? -Speed / A : Left;
        // 5. Along the parabola: exact while the force is constant.
        Moved += (Speed + 0.5 * A * T) * T;
        Speed = bStops ? 0.0 : Speed + A * T;
        // 6. Go on with what is left of the step.
        Left -= T;
    }
    Position += Along * Moved;
    Velocity = Along * Speed;
}

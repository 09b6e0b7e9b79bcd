#include "CoreMinimal.h"

/** Moves a body that slides on a surface by DeltaTime seconds. */
void Step(FVector& Position, FVector& Velocity, double DeltaTime,
          const FVector& Gravity, const FVector& Normal,
          double MuStatic, double MuKinetic)
{
    // 1. Gravity drives along the surface and presses into it.
    const FVector Drive = Gravity - Normal * FVector::DotProduct(Gravity, Normal);
    const double Press = FMath::Max(0.0, -FVector::DotProduct(Gravity, Normal));
    const double Hold = FMath::Max(MuStatic, MuKinetic) * Press;
    Velocity -= Normal * FVector::DotProduct(Velocity, Normal);
    double Left = DeltaTime;
    while (Left > 0.0)
    {
        // 2. At rest, static friction decides: stay, or set off.
        const double Speed = Velocity.Size();
        if (Speed == 0.0 && Drive.Size() <= Hold) break;
        // 3. Sliding, friction pulls against the way it slides.
        const FVector Way = Speed > 0.0 ? Velocity : Drive;
        FVector A = Drive - Way * (MuKinetic * Press / Way.Size());
        // 4. If it stops within this part of the step, go only to that instant.
        double T = FMath::Max(DeltaTime / 1000.0, 0.02 * Speed / A.Size());
        T = FMath::Min(Left, T);
        const double Brake = -FVector::DotProduct(A, Way) / Way.Size();
        const bool bStops = Brake > 0.0 && Speed / Brake <= T;
        if (bStops) T = Speed / Brake;
        // 5. The way turns: what it is halfway is right for the whole part.
        const FVector Halfway = bStops ? Way : Way + A * (T / 2.0);
        A = Drive - Halfway * (MuKinetic * Press / Halfway.Size());
        Position += Velocity * T + A * (T * T / 2.0);
        Velocity = bStops ? FVector(0.0, 0.0, 0.0) : Velocity + A * T;
        // 6. Go on with what is left of the step.
        Left -= T;
    }
}

#include "step.cpp"
#include "step3d.cpp"
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

int main()
{
    std::string Line;
    while (std::getline(std::cin, Line))
    {
        std::istringstream In(Line);
        int Dimensions;
        double N[9], MuStatic, MuKinetic, T;
        In >> Dimensions;
        for (int I = 0; I < 3 * Dimensions; I++) In >> N[I];
        In >> MuStatic >> MuKinetic;
        if (Dimensions == 2)
        {
            FVector2D R(0.0, 0.0), V(N[0], N[1]);
            while (In >> T)
            {
                Step(R, V, T, FVector2D(N[2], N[3]), FVector2D(N[4], N[5]), MuStatic, MuKinetic);
                std::printf("row %.17g %.17g %.17g %.17g\n", R.X, R.Y, V.X, V.Y);
            }
            continue;
        }
        FVector R(0.0, 0.0, 0.0), V(N[0], N[1], N[2]);
        while (In >> T)
        {
            Step(R, V, T, FVector(N[3], N[4], N[5]), FVector(N[6], N[7], N[8]), MuStatic, MuKinetic);
            std::printf("row %.17g %.17g %.17g %.17g %.17g %.17g\n", R.X, R.Y, R.Z, V.X, V.Y, V.Z);
        }
    }
}

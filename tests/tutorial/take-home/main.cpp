#include "step.cpp"
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
        double U, W, Gx, Gy, Nx, Ny, MuStatic, MuKinetic, DeltaTime;
        In >> U >> W >> Gx >> Gy >> Nx >> Ny >> MuStatic >> MuKinetic;
        FVector2D Position(0.0, 0.0), Velocity(U, W);
        while (In >> DeltaTime)
        {
            Step(Position, Velocity, DeltaTime, FVector2D(Gx, Gy), FVector2D(Nx, Ny), MuStatic, MuKinetic);
            std::printf("row %.17g %.17g %.17g %.17g\n", Position.X, Position.Y, Velocity.X, Velocity.Y);
        }
    }
}

// As much of Unreal's CoreMinimal.h as step.cpp and step3d.cpp need.
#pragma once
#include <algorithm>
#include <cmath>

struct FVector2D
{
    double X = 0.0, Y = 0.0;
    FVector2D(double InX, double InY) : X(InX), Y(InY) {}
    static double DotProduct(const FVector2D& A, const FVector2D& B) { return A.X * B.X + A.Y * B.Y; }
    FVector2D operator*(double Scale) const { return FVector2D(X * Scale, Y * Scale); }
    FVector2D& operator+=(const FVector2D& V) { X += V.X; Y += V.Y; return *this; }
};

struct FVector
{
    double X = 0.0, Y = 0.0, Z = 0.0;
    FVector(double InX, double InY, double InZ) : X(InX), Y(InY), Z(InZ) {}
    static double DotProduct(const FVector& A, const FVector& B) { return A.X * B.X + A.Y * B.Y + A.Z * B.Z; }
    double Size() const { return std::sqrt(X * X + Y * Y + Z * Z); }
    FVector operator*(double Scale) const { return FVector(X * Scale, Y * Scale, Z * Scale); }
    FVector operator+(const FVector& V) const { return FVector(X + V.X, Y + V.Y, Z + V.Z); }
    FVector operator-(const FVector& V) const { return FVector(X - V.X, Y - V.Y, Z - V.Z); }
    FVector& operator+=(const FVector& V) { return *this = *this + V; }
    FVector& operator-=(const FVector& V) { return *this = *this - V; }
};

struct FMath
{
    static double Min(double A, double B) { return std::min(A, B); }
    static double Max(double A, double B) { return std::max(A, B); }
    static double Abs(double A) { return std::fabs(A); }
    static double Sign(double A) { return A > 0.0 ? 1.0 : A < 0.0 ? -1.0 : 0.0; }
};

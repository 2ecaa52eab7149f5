#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scb/vec.h"

namespace scb {

/// Points as three parallel arrays of coordinates, owned elsewhere.
struct PointsView {
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
    std::size_t size = 0;

    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    /// `count` points from `first` on.
    PointsView sub(std::size_t first, std::size_t count) const {
        return {x + first, y + first, z + first, count};
    }
};

/// Points as three parallel arrays of coordinates.
struct PointArrays {
    std::vector<double> x, y, z;

    PointArrays() = default;
    explicit PointArrays(std::span<const Vec3> points) {
        reserve(points.size());
        for (const Vec3& p : points) push_back(p);
    }

    std::size_t size() const { return x.size(); }
    void reserve(std::size_t n) {
        x.reserve(n);
        y.reserve(n);
        z.reserve(n);
    }
    void resize(std::size_t n) {
        x.resize(n);
        y.resize(n);
        z.resize(n);
    }
    void set(std::size_t i, const Vec3& p) {
        x[i] = p[0];
        y[i] = p[1];
        z[i] = p[2];
    }
    void push_back(const Vec3& p) {
        x.push_back(p[0]);
        y.push_back(p[1]);
        z.push_back(p[2]);
    }
    void clear() {
        x.clear();
        y.clear();
        z.clear();
    }
    PointsView view() const { return {x.data(), y.data(), z.data(), size()}; }
};

}  // namespace scb

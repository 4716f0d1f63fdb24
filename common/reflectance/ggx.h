/// The GGX microfacet lobe: Smith height-correlated masking (Heitz 2014), Schlick Fresnel, sampled by visible
/// normals (Heitz 2018). Local frame: z is the normal.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

struct GgxLobe {
  /// Below it the lobe is narrower than float directions can tell apart.
  static constexpr float least_alpha = 1e-4F;

  Rgb f0;              ///< Schlick reflectance at normal incidence
  float alpha = 1.0F;  ///< roughness², at least least_alpha

  /// BRDF value without the cosine, 1/sr: F D G2 / (4 cos θo cos θi) (Heitz 2014, Eq. 1 and 99).
  Rgb evaluate(const Vec3& outgoing, const Vec3& incoming) const {
    if (outgoing.z <= 0.0F || incoming.z <= 0.0F) return Rgb();
    const Vec3 half = glm::normalize(outgoing + incoming);
    const float masking = 1.0F / (1.0F + lambda(outgoing) + lambda(incoming));
    return fresnel(glm::dot(outgoing, half)) * (distribution(half) * masking / (4.0F * outgoing.z * incoming.z));
  }
  /// Density of sample(), 1/sr: G1 D / (4 cos θo).
  float pdf(const Vec3& outgoing, const Vec3& incoming) const {
    if (outgoing.z <= 0.0F || incoming.z <= 0.0F) return 0.0F;
    const Vec3 half = glm::normalize(outgoing + incoming);
    return distribution(half) / ((1.0F + lambda(outgoing)) * 4.0F * outgoing.z);
  }
  /// evaluate() · cos θi / pdf() of a sampled direction, without the quotient's cancellation: F G2 / G1.
  Rgb weight(const Vec3& outgoing, const Vec3& incoming) const {
    if (outgoing.z <= 0.0F || incoming.z <= 0.0F) return Rgb();
    const Vec3 half = glm::normalize(outgoing + incoming);
    const float to_viewer = lambda(outgoing);
    return fresnel(glm::dot(outgoing, half)) * ((1.0F + to_viewer) / (1.0F + to_viewer + lambda(incoming)));
  }
  /// Mirror direction about a visible normal; it may lie below the surface, where the lobe carries nothing.
  Vec3 sample(const Vec3& outgoing, Vec2 u) const {
    const Vec3 stretched = glm::normalize(Vec3(alpha * outgoing.x, alpha * outgoing.y, outgoing.z));
    const float planar = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 first = planar > 0.0F ? Vec3(-stretched.y, stretched.x, 0.0F) / std::sqrt(planar) : Vec3(1.0F, 0.0F, 0.0F);
    const Vec3 second = glm::cross(stretched, first);
    const float radius = std::sqrt(u.x);
    const float angle = 2.0F * pi * u.y;
    const float x = radius * std::cos(angle);
    const float blend = 0.5F * (1.0F + stretched.z);
    const float y = (1.0F - blend) * std::sqrt(std::max(0.0F, 1.0F - x * x)) + blend * radius * std::sin(angle);
    const Vec3 visible = x * first + y * second + std::sqrt(std::max(0.0F, 1.0F - x * x - y * y)) * stretched;
    const Vec3 half = glm::normalize(Vec3(alpha * visible.x, alpha * visible.y, std::max(1e-7F, visible.z)));
    return 2.0F * glm::dot(outgoing, half) * half - outgoing;
  }

 private:
  /// D(h), 1/sr, from the components of h: exact also where the lobe is a needle.
  float distribution(const Vec3& half) const {
    const float x = half.x / alpha;
    const float y = half.y / alpha;
    const float sum = x * x + y * y + half.z * half.z;
    return 1.0F / (pi * alpha * alpha * sum * sum);
  }
  float lambda(const Vec3& direction) const {
    const float tangent_squared = (direction.x * direction.x + direction.y * direction.y) / (direction.z * direction.z);
    return 0.5F * (std::sqrt(1.0F + alpha * alpha * tangent_squared) - 1.0F);
  }
  Rgb fresnel(float cosine) const {
    const float rest = 1.0F - std::clamp(cosine, 0.0F, 1.0F);
    const float fifth = rest * rest * rest * rest * rest;
    return f0 + (Rgb(1.0F) - f0) * fifth;
  }
};

}  // namespace gibench

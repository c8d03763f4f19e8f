// The losses are Ceres' of the same names, value and first derivative, over numbers and over dual numbers.

#include "energies/pairs/point_pairs.h"

#include <ceres/jet.h>
#include <ceres/loss_function.h>
#include <gtest/gtest.h>

#include <memory>

namespace shellmatch {
namespace {

std::unique_ptr<ceres::LossFunction> of_ceres(RobustLoss loss, double scale) {
  if (loss == RobustLoss::huber) return std::make_unique<ceres::HuberLoss>(scale);
  if (loss == RobustLoss::cauchy) return std::make_unique<ceres::CauchyLoss>(scale);
  return std::make_unique<ceres::TrivialLoss>();
}

TEST(RobustLoss, IsThatOfCeres) {
  for (const auto& [loss, name] : EnumNames<RobustLoss>::names)
    for (const double scale : {0.01, 0.3, 2.0})
      for (const double s : {0.0, 1e-8, 1e-3, 0.09, 0.5, 4.0, 1e3}) {
        SCOPED_TRACE(std::string(name) + ", scale " + std::to_string(scale) + ", s " + std::to_string(s));
        std::array<double, 3> rho{};
        of_ceres(loss, scale)->Evaluate(s, rho.data());
        EXPECT_NEAR(robust_loss(loss, scale, s), rho[0], 1e-13 * (1 + rho[0]));
        EXPECT_NEAR(robust_weight(loss, scale, s), rho[1], 1e-14);
        const auto jet = robust_loss(loss, scale, ceres::Jet<double, 1>(s, 0));
        EXPECT_EQ(jet.a, robust_loss(loss, scale, s));
        EXPECT_NEAR(jet.v[0], rho[1], 1e-14);
      }
}

}  // namespace
}  // namespace shellmatch

// Each group of the self-test passes, and notices an error that is planted.

#include "matching/self_test/self_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

bool all_pass(const std::vector<SelfCheck>& checks) {
  return !checks.empty() && std::ranges::all_of(checks, [](const SelfCheck& c) { return c.passed(); });
}

TEST(SelfTest, WhatIsNoNumberFails) {
  EXPECT_TRUE((SelfCheck{"", "", 1, 1}.passed()));
  EXPECT_FALSE((SelfCheck{"", "", 1.01, 1}.passed()));
  EXPECT_FALSE((SelfCheck{"", "", std::nan(""), 1}.passed()));
  const std::vector<SelfCheck> checks = {{"a", "good", 0, 1}, {"a", "bad", 2, 1}, {"b", "worse", 3, 1}};
  EXPECT_EQ(failed_checks(checks), "a: bad, b: worse");
  const std::string text = self_test_text(checks);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("FAILED"), std::string::npos);
}

TEST(SelfTest, ClosedFormsHold) { EXPECT_TRUE(all_pass(check_closed_forms())) << self_test_text(check_closed_forms()); }

TEST(SelfTest, AWrongDerivativeFails) {
  EXPECT_TRUE(all_pass(check_gradients<2>()));
  GradientReport report;
  report.terms.resize(1);
  report.terms[0].directions.resize(1);
  report.terms[0].directions[0].orders = {2.0, 1.0};
  EXPECT_EQ(failed_checks(checks_of(report)), ": Taylor remainders: largest deviation from order 2");
  report.terms[0] = {};
  report.terms[0].gradient_error = 1e-3;
  EXPECT_EQ(failed_checks(checks_of(report)), ": gradients against dual numbers");
  report.terms[0] = {};
  report.terms[0].state = TermCheck::State::failed;
  EXPECT_EQ(failed_checks(checks_of(report)), ": terms whose derivatives are wrong");
}

template <int Dim>
void expect_certificates() {
  EXPECT_TRUE(all_pass(check_fold_certificates<Dim>())) << self_test_text(check_fold_certificates<Dim>());
  // The determinants at the corners bound nothing in space, and twice the bound is above what it is to bound.
  const auto corners = [](std::span<const Element<Dim>> cells, std::span<const Vec<Dim>> phi) {
    auto found = determinant_bounds<Dim>(cells, phi);
    for (DeterminantBounds& b : found) b.bound = Dim == 3 ? b.smallest : 2 * std::abs(b.bound);
    return found;
  };
  const auto checks = check_fold_certificates<Dim>(corners);
  EXPECT_FALSE(checks[0].passed() && checks[1].passed()) << self_test_text(checks);
}
TEST(SelfTest, AWrongCertificateFails) {
  expect_certificates<2>();
  expect_certificates<3>();
}

template <int Dim>
void expect_match() {
  const Similarity<Dim> motion = self_test_motion<Dim>();
  EXPECT_TRUE(all_pass(check_match<Dim>(motion, motion))) << self_test_text(check_match<Dim>(motion, motion));
  Similarity<Dim> wrong = motion;
  wrong.offset[0] += 0.05;
  EXPECT_EQ(failed_checks(check_match<Dim>(motion, wrong)), ": distance from the true positions, largest");
}
TEST(SelfTest, AWrongMatchFails) {
  expect_match<2>();
  expect_match<3>();
}

}  // namespace
}  // namespace shellmatch

#pragma once
/// \file
/// The energy terms at one point x of the domain: what each reads, and its density. A term is written once,
/// over a scalar T that is differentiated (what depends on phi) and a scalar P that is not (what depends on x
/// alone). The same text runs on numbers, on ceres::Jet, and on the recording scalar from which the fast code is
/// made (energies/autodiff).
///
/// Notation of the paper: d1, n1 and the root of C(S1) at x in the reference frame; d2, n2 and N^{1/2} =
/// C(S2)^{1/2} at phi(x) in the deformed frame; Dphi maps the first frame to the second.

#include "energies/autodiff/jet.h"
#include "energies/autodiff/pack.h"
#include "energies/densities/densities.h"
#include "energies/densities/small_matrix.h"

#include <cmath>

namespace shellmatch {

/// What is known of the reference shape at x. Does not depend on phi.
template <int Dim, class P>
struct ReferencePoint {
  P d1;                 ///< signed distance to M1
  SmallVec<P, Dim> n1;  ///< unit normal
  SmallSym<P, Dim> r1;  ///< P1 C(S1)^{-1/2} P1; S1 for QuadraticBending
  static constexpr int size = 1 + Dim + n_symmetric<Dim>;
};

/// What is known of the template shape at phi(x).
template <int Dim, class T>
struct TargetPoint {
  T d2;                  ///< signed distance to M2
  SmallVec<T, Dim> n2;   ///< normal as interpolated: not of unit length
  SmallSym<T, Dim> root; ///< C(S2)^{1/2}; S2 for QuadraticBending
  static constexpr int size = 1 + Dim + n_symmetric<Dim>;
};

/// Interpolated normals are shorter than 1 where they turn. Left alone this alone costs energy on identical
/// shapes; near the medial axis they may vanish, hence the guard.
template <class T, int Dim>
constexpr SmallVec<T, Dim> renormalised(const SmallVec<T, Dim>& n) {
  using autodiff::max_of;
  using std::sqrt;
  const T scale = 1.0 / sqrt(max_of(dot(n, n), T(1e-4)));
  SmallVec<T, Dim> r;
  for (int i = 0; i < Dim; ++i) r[i] = n[i] * scale;
  return r;
}

/// |d2(phi) - d1|^2, eq. (def:Ematch) without eta / nu.
template <int Dim>
struct Match {
  static constexpr const char* name = "match";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>&, const ReferencePoint<Dim, P>& x,
                             const Lame<P>&) {
    const T gap = y.d2 - x.d1;
    return gap * gap;
  }
};

/// W(P2 Dphi P1 + n2 n1^T), eq. (def:Emem) without delta eta.
template <int Dim>
struct Membrane {
  static constexpr const char* name = "membrane";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>& lame) {
    const auto n2 = renormalised(y.n2);
    return thin_shell_density(plus_outer(project_rows(project_columns(dphi, x.n1), n2), n2, x.n1), lame);
  }
};

/// W(Lambda), Lambda = P2 N^{1/2} P2 Dphi P1 M^{-1/2} P1 + n2 n1^T, eq. (def:Ebend) without delta^3 eta.
template <int Dim>
struct Bending {
  static constexpr const char* name = "bending";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>& lame) {
    const auto n2 = renormalised(y.n2);
    const auto tangential = project_rows(product<Dim>(dphi, x.r1), n2);
    return thin_shell_density(plus_outer(project_rows(product<Dim>(y.root, tangential), n2), n2, x.n1), lame);
  }
};

/// W(Dphi P1 + n2 n1^T): the membrane with P2 left out (paper, fig:cubes). Derivatives that leave the template's
/// tangent plane count as stretch, even where phi still has to find its way there.
template <int Dim>
struct MembraneWithoutP2 {
  static constexpr const char* name = "membrane without P2";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>& lame) {
    return thin_shell_density(plus_outer(project_columns(dphi, x.n1), renormalised(y.n2), x.n1), lame);
  }
};

/// W((Dphi P1)^T Dphi P1 + n1 n1^T), eq. (eq:badMem): vanishes for every tangential isometry, oscillating ones
/// included, and is not rank-one convex (paper, section 4.1). Knows nothing of the template.
template <int Dim>
struct CauchyGreenMembrane {
  static constexpr const char* name = "Cauchy-Green membrane";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>&, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>& lame) {
    const auto tangential = project_columns(dphi, x.n1);
    SmallMat<T, Dim> c;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        c(i, j) = tangential(0, i) * tangential(0, j);
        for (int k = 1; k < Dim; ++k) c(i, j) = c(i, j) + tangential(k, i) * tangential(k, j);
      }
    return thin_shell_density(plus_outer(c, x.n1, x.n1), lame);
  }
};

/// W(N^{1/2} Dphi P1 M^{-1/2} P1 + n2 n1^T): bending with P2 left out.
template <int Dim>
struct BendingWithoutP2 {
  static constexpr const char* name = "bending without P2";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>& lame) {
    const auto a = product<Dim>(y.root, product<Dim>(dphi, x.r1));
    return thin_shell_density(plus_outer(a, renormalised(y.n2), x.n1), lame);
  }
};

/// |Dphi^T S2 Dphi - S1|^2, which is not rank-one convex (paper, section 3.2). Reads the shape operators
/// themselves: y.root is S2 and x.r1 is S1 here.
template <int Dim>
struct QuadraticBending {
  static constexpr const char* name = "quadratic bending";
  template <class T, class P>
  static constexpr T density(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                             const ReferencePoint<Dim, P>& x, const Lame<P>&) {
    const auto s2_dphi = product<Dim>(y.root, dphi);
    T sum(0.0);
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        T pulled_back = dphi(0, i) * s2_dphi(0, j);
        for (int k = 1; k < Dim; ++k) pulled_back = pulled_back + dphi(k, i) * s2_dphi(k, j);
        const T gap = pulled_back - x.r1(i, j);
        sum = sum + gap * gap;
      }
    return sum;
  }
};

/// W(Dphi), the simplified volume term of the paper's experiments, without c_vol.
template <int Dim>
struct SimplifiedVolume {
  template <class T, class P>
  static constexpr T density(const SmallMat<T, Dim>& dphi, const Lame<P>& lame) {
    return thin_shell_density(dphi, lame);
  }
};

/// W_hat(Dphi), eq. (def:Evol), without c_vol.
template <int Dim>
struct FullVolume {
  template <class T, class P>
  static constexpr T density(const SmallMat<T, Dim>& dphi, const Lame<P>&) {
    return full_volume_density(dphi);
  }
};

/// Symmetric Dirichlet energy of Dphi, without c_vol.
template <int Dim>
struct SymmetricDirichletVolume {
  template <class T, class P>
  static constexpr T density(const SmallMat<T, Dim>& dphi, const Lame<P>& lame) {
    return symmetric_dirichlet_density(dphi, lame.mu);
  }
};

/// A term of the band as a function of flat arrays, for recording. Active inputs: d2, n2, root, Dphi by rows;
/// passive inputs: d1, n1, r1, lambda, mu.
template <class Term, int Dim>
struct BandFunctor {
  static constexpr int n_target = TargetPoint<Dim, double>::size;
  static constexpr int n_active = n_target + Dim * Dim;
  static constexpr int n_passive = ReferencePoint<Dim, double>::size + 2;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    TargetPoint<Dim, T> y;
    ReferencePoint<Dim, P> x;
    SmallMat<T, Dim> dphi;
    y.d2 = *active++;
    for (T& e : y.n2.v) e = *active++;
    for (T& e : y.root.v) e = *active++;
    for (T& e : dphi.v) e = *active++;
    x.d1 = *passive++;
    for (P& e : x.n1.v) e = *passive++;
    for (P& e : x.r1.v) e = *passive++;
    return Term::density(y, dphi, x, Lame<P>{passive[0], passive[1]});
  }
};

/// A volume term likewise. Active: Dphi by rows; passive: lambda, mu.
template <class Term, int Dim>
struct VolumeFunctor {
  static constexpr int n_active = Dim * Dim;
  static constexpr int n_passive = 2;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    SmallMat<T, Dim> dphi;
    for (int i = 0; i < Dim * Dim; ++i) dphi.v[i] = active[i];
    return Term::density(dphi, Lame<P>{passive[0], passive[1]});
  }
};

}  // namespace shellmatch

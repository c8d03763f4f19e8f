#!/bin/sh
# rmutil 1.1.10 (R package, Debian 12): rgammacount(n, m, s) draws numbers that are too small by about a half, and qgammacount() is wrong likewise.
# With s = 1 the gamma count distribution is the Poisson distribution of mean m; pgammacount() and dgammacount() agree with it. But the mean of
# many draws of rgammacount(n, 3, 1) is 2.5, and 0 comes up in 11 per cent of them where it should in 5. The p-quantile of counts is the
# smallest whole number whose probability (of it or less) is p or more. qgammacount() solves pgammacount(q) = p by uniroot(), for a real q, as
# pgammacount() goes on smoothly between whole numbers, and rounds q to the nearest one; it should round up. So for half of all p the quantile
# is one too low, as in the example of the help, qgammacount(0.08, 10, 0.9), which is 5 though 5 or less has a probability of 0.0757 only. The
# mean falls by a half, by less for small m: for m = 0.5 and s = 1 it is 0.24. The other counts of the package (double Poisson, Consul, beta
# binomial) take the same steps, but their probabilities jump at whole numbers, so that the root lies there and rounding does no harm. They are
# right, and so is qpois(). Nothing is said. What is fitted to simulated counts has another m than the simulation.
set -eu
r=4.2.2.20221110-2
rmutil=1.1.10-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "r-base-core=$r" "r-cran-rmutil=$rmutil" libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libreadline8 libpcre2-8-0 libicu72 \
  libtirpc3 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
R_HOME=$folder/root/usr/lib/R
R_SHARE_DIR=$folder/root/usr/share/R/share
R_LIBS=$R_HOME/site-library
R_DEFAULT_PACKAGES=utils,stats,graphics,grDevices,methods
: > "$folder/Renviron"
ln -sf "$folder/Renviron" "$R_HOME/etc/Renviron"
EDITOR=vi
PAGER=cat
LD_LIBRARY_PATH=$R_HOME/lib:$(find "$folder/root/usr/lib" "$folder/root/lib" -path "$R_HOME" -prune -o -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
export R_HOME R_SHARE_DIR R_LIBS R_DEFAULT_PACKAGES EDITOR PAGER LD_LIBRARY_PATH
cat > count.R <<'R'
suppressMessages(library(rmutil))
cat(R.version.string, ", rmutil ", as.character(packageVersion("rmutil")), "\n", sep = "")
ok <- TRUE
set.seed(1)
n <- 10000
p <- (0:499 + 0.5) / 500
# the quantile by its definition, from the package's own probabilities
quantile.of <- function(p, cdf) sapply(p, function(a) which(cdf >= a)[1] - 1)
line <- function(name, draws, mean, zero) cat(sprintf("%-34s mean %.3f (right %.3f), share of zeros %.4f (right %.4f)\n", name, mean(draws), mean,
                                                      mean(draws == 0), zero))
k <- 0:300
for (m in c(0.5, 3, 20)) for (s in c(0.5, 1, 2)) {
  cdf <- pgammacount(k, m, s)
  right <- sum(1 - cdf)
  draws <- rgammacount(n, m, s)
  line(sprintf("rgammacount, m %g, s %g", m, s), draws, right, cdf[1])
  q <- qgammacount(p, m, s)
  want <- quantile.of(p, cdf)
  cat(sprintf("   qgammacount is one too low for %.0f per cent of the p, right for %.0f\n", 100 * mean(q == want - 1), 100 * mean(q == want)))
  ok <- ok && all(q == want | q == want - 1) && mean(draws) < right - 0.15 && abs(mean(q == want - 1) - (right - mean(draws))) < 0.15
  if (m >= 3) ok <- ok && abs(mean(draws) - right + 0.5) < 0.15
  # s = 1 is Poisson's distribution, for the probabilities
  if (s == 1) ok <- ok && max(abs(cdf - ppois(k, m))) < 1e-9 && max(abs(dgammacount(0:20, m, 1) - dpois(0:20, m))) < 1e-9 && all(want == qpois(p, m))
}
q <- qgammacount(c(0.1, 0.25, 0.5, 0.75, 0.9), 3, 1)
cat("m 3, s 1, quantiles for 0.1, 0.25, 0.5, 0.75, 0.9: qgammacount", q, "; qpois", qpois(c(0.1, 0.25, 0.5, 0.75, 0.9), 3), "\n")
ok <- ok && !identical(as.numeric(q), qpois(c(0.1, 0.25, 0.5, 0.75, 0.9), 3))
q <- qgammacount(0.08, 10, 0.9)
cat("the example of the help, qgammacount(0.08, 10, 0.9):", q, "; pgammacount of 5 and 6:", pgammacount(5:6, 10, 0.9), "\n")
ok <- ok && q == 5 && pgammacount(5, 10, 0.9) < 0.08 && pgammacount(6, 10, 0.9) > 0.08
# other counts of the package
set.seed(2)
other <- list(
  list("rdoublepois, m 3, s 2", rdoublepois(2000, 3, 2), ddoublepois(0:60, 3, 2)),
  list("rconsul, m 3, s 1.5", rconsul(2000, 3, 1.5), dconsul(0:60, 3, 1.5)),
  list("rbetabinom, of 10, m 0.3, s 2", rbetabinom(2000, 10, 0.3, 2), dbetabinom(0:10, 10, 0.3, 2)))
for (o in other) {
  right <- sum((seq_along(o[[3]]) - 1) * o[[3]])
  line(o[[1]], o[[2]], right, o[[3]][1])
  ok <- ok && abs(mean(o[[2]]) - right) < 0.12 && abs(mean(o[[2]] == 0) - o[[3]][1]) < 0.02
}
# the m that fits best to counts drawn with m = 3, s = 1, and to counts by rpois
best <- function(draws) optimize(function(m) -sum(dgammacount(draws, m, 1, log = TRUE)), c(0.5, 8))$minimum
set.seed(3)
a <- best(rgammacount(2000, 3, 1))
b <- best(rpois(2000, 3))
cat(sprintf("m fitted with dgammacount: %.2f to draws of rgammacount(2000, 3, 1), %.2f to those of rpois(2000, 3)\n", a, b))
ok <- ok && abs(a - 2.5) < 0.1 && abs(b - 3) < 0.1
quit(status = if (ok) 0 else 1)
R
"$R_HOME/bin/exec/R" --no-echo --no-restore --vanilla -f count.R

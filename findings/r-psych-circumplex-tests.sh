#!/bin/sh
# psych 2.2.9 (R package, Debian 12): the rotation and variance tests of circ.tests() do not come near 0, not even for a perfect circumplex. Both turn
# the loadings by 0, 5, ... 45 degrees, take a criterion for each and give its standard deviation over its mean, which is 0 for loadings evenly spaced
# on a circle. The loop of circ.rt() and circ.v2() runs i from 0 to 9 and stores in place [i] of ten zeros: R drops place 0 without a word, and place
# 10 stays zero. So the value at 0 degrees is lost, and a zero that nobody measured counts as the tenth. RT and VT of a perfect circumplex are 0.351
# (sqrt(0.1) / 0.9) for any number of items; for samples of 500, RT is 0.35 for a circumplex and 0.67 for simple structure, where 0.04 and 0.80 are
# right: twice as large for twenty times. The gap test leaves out the gap that holds the direction of 180 degrees, so that it changes when a ring of
# items is turned as a whole. The help advises to compare with simulations by the same package, which are off alike. Nothing is said.
set -eu
r=4.2.2.20221110-2
psych=2.2.9-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "r-base-core=$r" "r-cran-psych=$psych" r-cran-mnormt r-cran-lattice r-cran-nlme libblas3 liblapack3 libgfortran5 libquadmath0 \
  libgomp1 libreadline8 libpcre2-8-0 libicu72 libtirpc3
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
cat > circ.R <<'R'
suppressMessages(library(psych))
cat(R.version.string, ", psych ", as.character(packageVersion("psych")), "\n", sep = "")
ok <- TRUE
near <- function(a, b, tol = 1e-6) max(abs(a - b)) < tol
# the two tests with all ten angles
right <- function(l) {
  m <- sapply(0:9, function(k) {
    a <- k * pi / 36
    s <- (l[, 1:2] %*% rbind(c(cos(a), sin(a)), c(-sin(a), cos(a))))^2
    c(sum(apply(s, 1, var)), var(s[, 1] / sum(s)))
  })
  apply(m, 1, sd) / rowMeans(m)
}
got <- function(l) { t <- circ.tests(l, loading = FALSE); c(t$RT, t$VT) }
ring <- function(a) cbind(cos(a), sin(a))
line <- function(name, g, w) cat(sprintf("%-44s psych RT %.3f VT %.3f, right RT %.3f VT %.3f\n", name, g[1], g[2], w[1], w[2]))
for (n in c(8, 16, 40)) {
  l <- ring(2 * pi * (seq_len(n) - 0.3) / n)
  g <- got(l); w <- right(l)
  line(sprintf("%d items evenly on a circle", n), g, w)
  ok <- ok && near(w, 0) && near(g, sqrt(0.1) / 0.9)
}
# loadings fitted to the correlations of a sample of 500
fitted <- function(l, seed) {
  set.seed(seed)
  n <- 500
  x <- matrix(rnorm(n * 2), n) %*% t(0.6 * l) + 0.8 * matrix(rnorm(n * nrow(l)), n)
  unclass(fa(cor(x), 2, rotate = "none")$loadings)
}
even <- ring(2 * pi * (1:24) / 24)
axes <- ring(rep(c(0, pi / 2, pi, -pi / 2), 6))
res <- sapply(1:10, function(s) { c <- fitted(even, s); a <- fitted(axes, s); c(got(c), right(c), got(a), right(a)) })
m <- rowMeans(res)
line("circumplex, 24 items, 500 people, mean of 10", m[1:2], m[3:4])
line("simple structure, likewise", m[5:6], m[7:8])
ok <- ok && m[3] < 0.06 && m[7] > 0.7 && near(m[1], 0.354, 0.01) && m[5] / m[1] < 2.2 && m[7] / m[3] > 15
# the gaps of a ring of items that is turned
a <- c(0.1, 0.5, 1.3, 1.5, 2.2, 3.6, 4.0, 4.3, 5.0, 5.8)
all.gaps <- var(diff(c(a, a[1] + 2 * pi)))
g <- sapply(c(0, 1, 2, 3), function(t) circ.tests(ring(a + t), loading = FALSE)$gaps)
cat(sprintf("gaps of 10 items, all turned by 0, 1, 2, 3 radians: %s, variance of the ten gaps %.3f\n",
            paste(sprintf("%.3f", g), collapse = ", "), all.gaps))
ok <- ok && max(g) - min(g) > 0.05
quit(status = if (ok) 0 else 1)
R
"$R_HOME/bin/exec/R" --slave --no-restore --no-save --no-environ --no-site-file --no-init-file -f circ.R < /dev/null

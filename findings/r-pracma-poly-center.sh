#!/bin/sh
# pracma 2.4.2 (R package, Debian 12): poly_center() does not give the centre of mass of a polygon written as the help asks for it. The page it
# shares with polyarea() says that the polygon is closed automatically and that the last point 'need not be / should not be the same as the first'.
# polyarea() does so; poly_center() sums over the edges between successive points, leaves out the one from the last point to the first, and divides
# by the area of the closed polygon. What is lacking grows with the distance from the origin: a rectangle of 2 x 1 at the origin has its centre
# right (the missing edge lies on a line through the origin and counts nothing), moved by (10, 5) the centre is at (27.7, 14.7), far outside, and it
# depends on which corner one starts from. With the first point repeated at the end, against the help's advice, it is right. poly_length() is short
# of the same edge. Nothing is said.
set -eu
r=4.2.2.20221110-2
pracma=2.4.2-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "r-base-core=$r" "r-cran-pracma=$pracma" libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libreadline8 libpcre2-8-0 libicu72 \
  libtirpc3
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
cat > center.R <<'R'
suppressMessages(library(pracma))
cat(R.version.string, ", pracma ", as.character(packageVersion("pracma")), "\n", sep = "")
# the centre as the mean of the centres of a fan of triangles, weighted with their signed areas
center <- function(p) {
  k <- 2:(nrow(p) - 1)
  u <- sweep(p[k, , drop = FALSE], 2, p[1, ]); v <- sweep(p[k + 1, , drop = FALSE], 2, p[1, ])
  w <- (u[, 1] * v[, 2] - u[, 2] * v[, 1]) / 2
  c(sum(w), p[1, ] + colSums(w * (u + v) / 3) / sum(w))
}
as.described <- TRUE
show <- function(name, p, right.expected) {
  ref <- center(p)
  got <- poly_center(p[, 1], p[, 2])
  closed <- rbind(p, p[1, ])
  twice <- poly_center(closed[, 1], closed[, 2])
  cat(sprintf("%-44s area %.3f (right %.3f), poly_center (%.3f, %.3f), right (%.3f, %.3f), first point repeated (%.3f, %.3f)\n", name,
              polyarea(p[, 1], p[, 2]), ref[1], got[1], got[2], ref[2], ref[3], twice[1], twice[2]))
  ok <- function(x) max(abs(x - ref[2:3])) < 1e-9
  as.described <<- as.described && abs(polyarea(p[, 1], p[, 2]) - ref[1]) < 1e-9 && ok(twice) && ok(got) == right.expected
  invisible(got)
}
rectangle <- rbind(c(0, 0), c(2, 0), c(2, 1), c(0, 1))
show("rectangle with a corner in the origin", rectangle, TRUE)
moved <- sweep(rectangle, 2, c(10, 5), "+")
b <- show("moved by (10, 5)", moved, FALSE)
other <- show("the same from its second corner", moved[c(2, 3, 4, 1), ], FALSE)
as.described <- as.described && max(abs(b - c(83, 44) / 3)) < 1e-9 && max(abs(b - other)) > 1
triangle <- rbind(c(1, 1), c(4, 1), c(1, 5))
show("triangle (1,1), (4,1), (1,5)", triangle, FALSE)
t <- seq(0, 2 * pi, length.out = 101)[-101]
show("circle of radius 1 about (3, 4), 100 points", cbind(3 + cos(t), 4 + sin(t)), FALSE)
cat(sprintf("poly_length of the rectangle: %g, its perimeter is 6\n", poly_length(moved[, 1], moved[, 2])))
as.described <- as.described && poly_length(moved[, 1], moved[, 2]) == 5
quit(status = if (as.described) 0 else 1)
R
"$R_HOME/bin/exec/R" --slave --no-restore --no-save --no-environ --no-site-file --no-init-file -f center.R

#!/bin/sh
# terra 1.7-3 (R package, Debian 12): Geary's C of a raster, autocor(x, w, "geary"), uses the weights w in the denominator only. The method for
# SpatRaster lets focal() run over a window of dim(w) and sums the squared differences to every cell in it, whatever w says; the sum of the weights it
# is divided by does heed w. So with the rook's case of the help page (4 neighbours) pure noise has a C of 2 where 1 is right, which reads as strong
# negative autocorrelation, and C of a smooth surface triples; with weights of 1 / distance in 5 x 5 cells it is about twice too large; ten times
# the weights give a tenth of C, though C does not depend on their scale. raster 3.6-14, from which the function comes, has the weights in both sums
# and is right, and so is terra's own autocor() of a vector with a matrix of neighbours. Right only where all weights are 1, as with the default.
# The local Geary (global = FALSE) is the same for rook and queen. Moran's I does use w. Nothing is said.
set -eu
r=4.2.2.20221110-2
terra=1.7-3-1
raster=3.6-14-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "r-base-core=$r" "r-cran-terra=$terra" "r-cran-raster=$raster" r-cran-sp r-cran-rcpp r-cran-lattice proj-data \
  libaec0 libaom3 libarmadillo11 libarpack2 libblas3 libblosc1 libbrotli1 libbz2-1.0 libcfitsio10 libcom-err2 libcurl3-gnutls libcurl4 \
  libdav1d6 libde265-0 libdeflate0 libexpat1 libffi8 libfontconfig1 libfreetype6 libfreexl1 libfyba0 libgdal32 libgeos-c1v5 libgeos3.11.1 \
  libgeotiff5 libgfortran5 libgif7 libgmp10 libgnutls30 libgomp1 libgssapi-krb5-2 libhdf4-0-alt libhdf5-103-1 libhdf5-hl-100 libheif1 \
  libhogweed6 libicu72 libidn2-0 libjbig0 libjpeg62-turbo libjson-c5 libk5crypto3 libkeyutils1 libkmlbase1 libkmldom1 libkmlengine1 libkrb5-3 \
  libkrb5support0 liblapack3 liblcms2-2 libldap-2.5-0 liblerc4 libltdl7 liblz4-1 liblzma5 libmariadb3 libminizip1 libnetcdf19 libnettle8 \
  libnghttp2-14 libnuma1 libodbc2 libodbcinst2 libogdi4.1 libopenjp2-7 libp11-kit0 libpcre2-8-0 libpng16-16 libpoppler126 libpq5 libproj25 \
  libpsl5 libqhull-r8.0 libquadmath0 libreadline8 librtmp1 librttopo1 libsasl2-2 libsnappy1v5 libspatialite7 libsqlite3-0 libssh2-1 libssl3 \
  libsz2 libtasn1-6 libtiff6 libtinfo6 libtirpc3 libunistring2 liburiparser1 libwebp7 libx265-199 libxml2 libzstd1
for package in *.deb; do dpkg -x "$package" root; done
R_HOME=$folder/root/usr/lib/R
R_SHARE_DIR=$folder/root/usr/share/R/share
R_LIBS=$R_HOME/site-library
R_DEFAULT_PACKAGES=utils,stats,graphics,grDevices,methods
PROJ_LIB=$folder/root/usr/share/proj
PROJ_DATA=$PROJ_LIB
: > "$folder/Renviron"
ln -sf "$folder/Renviron" "$R_HOME/etc/Renviron"
EDITOR=vi
PAGER=cat
LD_LIBRARY_PATH=$R_HOME/lib:$(find "$folder/root/usr/lib" "$folder/root/lib" -path "$R_HOME" -prune -o -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
export R_HOME R_SHARE_DIR R_LIBS R_DEFAULT_PACKAGES EDITOR PAGER LD_LIBRARY_PATH PROJ_LIB PROJ_DATA
cat > geary.R <<'R'
suppressMessages({ library(terra); library(raster) })
cat(R.version.string, ", terra ", as.character(packageVersion("terra")), ", raster ", as.character(packageVersion("raster")), "\n", sep = "")
ok <- TRUE
near <- function(a, b, tol = 1e-9) max(abs(a - b)) < tol
n <- 20
grid <- rast(nrows = n, ncols = n, xmin = 0, xmax = n, ymin = 0, ymax = n, crs = "+proj=utm +zone=31")
xy <- xyFromCell(grid, 1:n^2)
# the weights between all pairs of cells that a window stands for
pairs <- function(w) {
  h <- (nrow(w) - 1) / 2
  dx <- outer(xy[, 1], xy[, 1], "-"); dy <- outer(xy[, 2], xy[, 2], "-")
  inside <- abs(dx) <= h & abs(dy) <= h
  W <- matrix(0, n^2, n^2)
  W[inside] <- w[cbind(dy[inside] + h + 1, dx[inside] + h + 1)]
  W
}
show <- function(name, z, w, factor) {
  values(grid) <- z
  W <- pairs(w)
  right <- (n^2 - 1) * sum(W * outer(z, z, "-")^2) / (2 * sum(W) * sum((z - mean(z))^2))
  got <- unname(autocor(grid, w, "geary"))
  old <- Geary(raster(grid), w)
  vec <- autocor(z, W, "geary")
  cat(sprintf("%-38s terra's raster %.4f, right %.4f, package raster %.4f, terra's vector %.4f, ratio %.3f\n",
              name, got, right, old, vec, got / right))
  ok <<- ok && near(c(old, vec), right) && near(got / right, factor, if (factor %in% c(1, 0.1)) 1e-9 else 0.15)
}
set.seed(1)
noise <- rnorm(n^2)
smooth <- sin(xy[, 1] / 4) + cos(xy[, 2] / 5)
rook <- matrix(c(0, 1, 0, 1, 0, 1, 0, 1, 0), 3)
queen <- matrix(c(1, 1, 1, 1, 0, 1, 1, 1, 1), 3)
a <- outer(-2:2, -2:2, function(x, y) sqrt(x^2 + y^2))
inverse <- ifelse(a == 0, 0, 1 / a)
show("noise, queen (the default)", noise, queen, 1)
show("noise, ten times queen", noise, 10 * queen, 0.1)
show("noise, rook", noise, rook, 1.94)
show("smooth surface, rook", smooth, rook, 2.9)
show("noise, 1 / distance, 5 x 5", noise, inverse, 1.70)
show("smooth surface, 1 / distance, 5 x 5", smooth, inverse, 2.1)
values(grid) <- noise
d <- values(autocor(grid, rook, "geary", global = FALSE)) - values(autocor(grid, queen, "geary", global = FALSE))
cat(sprintf("local Geary, largest difference between rook and queen: %g\n", max(abs(d))))
ok <- ok && near(d, 0)
quit(status = if (ok) 0 else 1)
R
"$R_HOME/bin/exec/R" --slave --no-restore --no-save --no-environ --no-site-file --no-init-file -f geary.R < /dev/null

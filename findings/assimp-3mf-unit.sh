#!/bin/sh
# assimp 5.2.5 (Debian 12) reads a 3MF model whose unit is the inch as if it were in millimetres: its coordinates are not scaled, the root's
# transformation is the identity, and neither UnitScaleFactor nor another entry of the scene's metadata has the unit. The 3MF core
# specification makes `unit` an attribute of <model> with six values. Parts from two programs differ by 25.4 without a word.
set -eu
version=5.2.5~ds0-1+b1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libassimp5=$version" "libassimp-dev=$version" libdraco7 libminizip1 libpugixml1v5
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libassimp.so.5' | head -n 1)")

cat > make.py <<'P'
import zipfile
with zipfile.ZipFile("inch.3mf", "w") as z:
    z.writestr("[Content_Types].xml", '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
               '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
               '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
    z.writestr("_rels/.rels", '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
               '<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
    z.writestr("3D/3dmodel.model", '<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
               '<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>'
               '<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>'
               '<triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh></object></resources>'
               '<build><item objectid="1"/></build></model>')
P
python3 make.py
cat > unit.cpp <<'C'
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <algorithm>
#include <cstdio>
#include <cstring>
int main() {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile("inch.3mf", 0);
  if (!scene || !scene->mNumMeshes) return std::printf("not read: %s\n", importer.GetErrorString()), 1;
  float most = 0;
  for (unsigned v = 0; v < scene->mMeshes[0]->mNumVertices; ++v) most = std::max(most, scene->mMeshes[0]->mVertices[v].x);
  bool has_unit = false;
  for (unsigned k = 0; scene->mMetaData && k < scene->mMetaData->mNumProperties; ++k)
    has_unit |= std::strstr(scene->mMetaData->mKeys[k].C_Str(), "nit") != nullptr;
  const bool identity = scene->mRootNode->mTransformation.IsIdentity();
  std::printf("an edge of 1 inch has length %g; root %s; unit in the metadata: %s\n", most, identity ? "identity" : "scaled", has_unit ? "yes" : "no");
  return !(most == 1 && identity && !has_unit);
}
C
c++ -std=c++17 -I root/usr/include unit.cpp -o unit -L "$lib" -lassimp -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./unit

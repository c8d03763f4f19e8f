#include "tests/fuzz/target.h"

#include <cstdio>
#include <cstdlib>

namespace shellmatch::fuzz {

namespace {

// The image that a PNG of a few bytes declares may take as much as the largest that is read
// (geometry/picture/read_mask.h).
constexpr std::size_t largest_image = std::size_t{700} << 20;

// Bytes that zlib expands, each to a number.
constexpr std::size_t largest_expansion = 30000;

// A byte of a volume's file may stand for a thousand voxels (geometry/volume/volume_header.cpp), which take 4 bytes
// each, twice where they are turned, and a few more where they are a label's.
constexpr std::size_t volume_start = std::size_t{32} << 20, most_per_volume_byte = 10000;

// A wrap has as many triangles as its bound on gaps asks for, however few the input has.
constexpr std::size_t wrap_memory = std::size_t{400} << 20;

constexpr Target all[] = {{"obj", read_obj_bytes},
                          {"off", read_off_bytes},
                          {"ply", read_ply_bytes},
                          {"stl", read_stl_bytes},
                          {"vtk", read_vtk_bytes},
                          {"vtp", read_vtp_bytes, std::size_t{32} << 20, largest_expansion},
                          {"gifti", read_gifti_bytes, std::size_t{32} << 20, largest_expansion},
                          {"freesurfer", read_freesurfer_bytes},
                          {"gltf", read_gltf_bytes, std::size_t{32} << 20},
                          {"collada", read_collada_bytes},
                          {"three_mf", read_three_mf_bytes, std::size_t{32} << 20, largest_expansion},
                          {"points2", read_points_of_plane},
                          {"points3", read_points_of_space},
                          {"tps", read_tps_bytes},
                          {"roi", read_roi_bytes, std::size_t{32} << 20, largest_expansion},
                          {"geojson", read_geojson_bytes},
                          {"svg", read_svg_bytes, std::size_t{64} << 20},
                          {"png", read_png_bytes, largest_image},
                          {"pgm", read_pgm_bytes},
                          {"tiff", read_tiff_bytes, largest_image},
                          {"jpeg", read_jpeg_bytes, largest_image},
                          {"bmp", read_bmp_bytes, largest_image},
                          {"nifti", read_nifti_bytes, volume_start, most_per_volume_byte},
                          {"nifti_gz", read_compressed_nifti_bytes, volume_start, most_per_volume_byte},
                          {"nrrd", read_nrrd_bytes, volume_start, most_per_volume_byte},
                          {"meta_image", read_meta_image_bytes, volume_start, most_per_volume_byte},
                          {"vti", read_vti_bytes, volume_start, largest_expansion},
                          {"repair3", mend_edited_mesh},
                          {"close3", close_edited_mesh, wrap_memory},
                          {"repair2", mend_edited_outline},
                          {"yaml", read_options},
                          {"experiment", read_whole_experiment},
                          {"study", read_whole_study},
                          {"subjects", read_table_of_subjects},
                          {"cohort", read_whole_cohort},
                          {"map", read_map_file},
                          {"history", read_history_file},
                          {"summary", read_summary_file},
                          {"manifest", read_manifest_file},
                          {"levels", read_kept_levels},
                          {"alignment", read_kept_alignment, std::size_t{32} << 20, largest_expansion},
                          {"files", read_list_of_files},
                          {"run_result", read_result_of_run},
                          {"landmarks", read_landmark_files},
                          {"fcsv", read_fcsv_file},
                          {"markups", read_markups_file},
                          {"correspondence", read_correspondence_file}};

}  // namespace

std::span<const Target> targets() { return all; }

const Target& target_named(std::string_view name) {
  for (const Target& target : all)
    if (target.name == name) return target;
  std::fprintf(stderr, "there is no target '%.*s'\n", static_cast<int>(name.size()), name.data());
  std::abort();
}

void demand(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", promise);
  std::abort();
}

}  // namespace shellmatch::fuzz

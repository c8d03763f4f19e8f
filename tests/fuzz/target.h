#pragma once
/// \file
/// The readers that scripts/fuzz feeds: whatever the bytes, a reader returns what its header promises or throws an
/// InputError.

#include <cstddef>
#include <span>
#include <string_view>

namespace shellmatch::fuzz {

struct Target {
  std::string_view name;
  /// Reads the bytes as a file of the format and demands what the reader promises. \throws InputError where it refuses
  /// them
  void (*read)(std::string_view bytes);
  /// Memory that the reader may hold at a time: so much, and so much more for each byte of input.
  std::size_t most_bytes = std::size_t{32} << 20, most_bytes_per_byte = 1500;
};

std::span<const Target> targets();

/// Aborts where there is no target of the name.
const Target& target_named(std::string_view name);

/// Aborts, for the fuzzer to see, unless the promise holds.
void demand(bool holds, const char* promise);

/// Between the files, or file and options, that make up the input of one target.
inline constexpr char separator = '\x1e';

void read_obj_bytes(std::string_view bytes);
void read_off_bytes(std::string_view bytes);
void read_ply_bytes(std::string_view bytes);
void read_stl_bytes(std::string_view bytes);
void read_vtk_bytes(std::string_view bytes);
void read_vtp_bytes(std::string_view bytes);
void read_gifti_bytes(std::string_view bytes);
void read_freesurfer_bytes(std::string_view bytes);
void read_gltf_bytes(std::string_view bytes);
void read_collada_bytes(std::string_view bytes);
void read_three_mf_bytes(std::string_view bytes);
void read_points_of_plane(std::string_view bytes);
void read_points_of_space(std::string_view bytes);
void read_tps_bytes(std::string_view bytes);
void read_roi_bytes(std::string_view bytes);
void read_geojson_bytes(std::string_view bytes);
void read_svg_bytes(std::string_view bytes);
void read_png_bytes(std::string_view bytes);
void read_tiff_bytes(std::string_view bytes);
void read_jpeg_bytes(std::string_view bytes);
void read_bmp_bytes(std::string_view bytes);
void read_pgm_bytes(std::string_view bytes);
void read_nifti_bytes(std::string_view bytes);
void read_compressed_nifti_bytes(std::string_view bytes);
void read_nrrd_bytes(std::string_view bytes);
void read_meta_image_bytes(std::string_view bytes);
void read_vti_bytes(std::string_view bytes);
void mend_edited_mesh(std::string_view bytes);
void close_edited_mesh(std::string_view bytes);
void mend_edited_outline(std::string_view bytes);
void read_options(std::string_view bytes);
void read_whole_experiment(std::string_view bytes);
void read_whole_study(std::string_view bytes);
void read_table_of_subjects(std::string_view bytes);
void read_whole_cohort(std::string_view bytes);
void read_map_file(std::string_view bytes);
void read_history_file(std::string_view bytes);
void read_summary_file(std::string_view bytes);
void read_manifest_file(std::string_view bytes);
void read_kept_levels(std::string_view bytes);
void read_kept_alignment(std::string_view bytes);
void read_list_of_files(std::string_view bytes);
void read_result_of_run(std::string_view bytes);
void read_landmark_files(std::string_view bytes);
void read_fcsv_file(std::string_view bytes);
void read_markups_file(std::string_view bytes);
void read_correspondence_file(std::string_view bytes);

}  // namespace shellmatch::fuzz

/// Volumes that are read by libraries of others, which are not to be trusted with foreign files: called in the import's
/// own process only (worker.h).
#pragma once

#include <filesystem>

#include "scenarios/import/image.h"

namespace cusp::scenarios {

/// NIfTI-1, .nii, .nii.gz and .hdr with .img; niftilib reads the header (nifti_niftilib.cpp). Its world is
/// right-anterior-superior as the specimen's: sform, else qform, else the spacings alone. Scaled by scl_slope and scl_inter.
[[nodiscard]] Result<Image, ImportFailure> read_nifti(const std::filesystem::path& file, const VolumeLimits& limits,
                                                      const ImportProgress& progress = {});

struct DicomSeries {
  Image image;              // of CT numbers: stored values times rescale slope plus intercept
  std::size_t series = 1;   // in the folder; the one with the most slices was read
  std::size_t slices = 0;
};
/// A CT series by DCMTK (dicom_dcmtk.cpp): a folder, or one slice whose series stands beside it. Slices are put in order
/// by their place along the series' normal, whatever their files are called. Nothing about the patient is read.
[[nodiscard]] Result<DicomSeries, ImportFailure> read_dicom(const std::filesystem::path& path, const VolumeLimits& limits,
                                                            const ImportProgress& progress = {});

/// Whether a file begins as a DICOM file does, whatever its name ends in.
bool looks_like_dicom(const std::filesystem::path& file);

}  // namespace cusp::scenarios

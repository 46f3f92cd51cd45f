// CT series as others write them; the files are made here, byte by byte.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "scenarios/import/foreign_images.h"
#include "scenarios/import/import.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"
#include "tests/scenarios/import/packed_dicom.h"

namespace cusp::test {
namespace {

float at(const Image& image, int x, int y, int z) {
  const IVec3 n = image.layout.size;
  return image.value[static_cast<std::size_t>(x + n.x * (y + n.y * z))];
}

struct Dicom : ::testing::Test {
  TempFolder folder;
  /// Slice n of a series along z: its pixels hold n, its place is 0.5 n.
  DicomWish slice(int n) const {
    DicomWish w;
    w.columns = 3;
    w.rows = 2;
    w.position = {-1.0, -2.0, 0.5 * n};
    w.across_mm = 0.2;
    w.down_mm = 0.3;
    w.thickness_mm = 0.5;
    w.number = n + 1;
    w.values = values_of({3, 2, 1}, [&](IVec3 v) { return v.x + 10 * v.y + 100 * n; });
    return w;
  }
  void put(const std::string& name, const DicomWish& w) const { write_text(folder / name, dicom_file(w)); }
};

TEST_F(Dicom, InWhosePlaceAPipeLiesWaitsForNobody) {
  for (const char* name : {"slice", "slice.dcm"}) ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
  EXPECT_EQ(file_kind(folder / "slice"), FileKind::unknown);
  EXPECT_EQ(read_dicom(folder / "slice.dcm", {}).error().code, ImportError::io);
}

TEST_F(Dicom, SlicesStandInTheOrderOfTheirPlacesWhateverTheirNames) {
  // Named without zeros in front, so that 10 stands before 2, and in an order that is none.
  for (int n = 0; n < 12; ++n) put(std::to_string(12 - n) + ".dcm", slice((n * 5) % 12));
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << key_of(ct.error().code) << ct.error().where << ct.error().detail;
  const ImageLayout& l = ct->image.layout;
  EXPECT_EQ(ct->slices, 12u);
  EXPECT_EQ(l.size, IVec3(3, 2, 12));
  EXPECT_LT(glm::length(l.spacing_mm - Vec3(0.2, 0.3, 0.5)), 1e-9);
  for (int z = 0; z < 12; ++z) EXPECT_EQ(at(ct->image, 2, 1, z), 100.0f * static_cast<float>(z));  // left-posterior to right-anterior
  EXPECT_EQ(at(ct->image, 0, 0, 3), 312.0f);
  // One slice is enough to find the others.
  const auto by_one = read_dicom(folder / "7.dcm", {});
  ASSERT_TRUE(by_one);
  EXPECT_EQ(by_one->image.value, ct->image.value);
}

TEST_F(Dicom, BesideLinksThatLeadNowhereTheSeriesIsRead) {
  for (int n = 0; n < 3; ++n) put(std::to_string(n), slice(n));
  const auto ends_with_link = [&] {
    bool link = false;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) link = entry.is_symlink();
    return link;
  };
  // What the folder lists last decides: a link that is followed leaves its failure there.
  for (int n = 0; n < 1000 && !ends_with_link(); ++n) std::filesystem::create_symlink("nowhere", folder / ("link" + std::to_string(n)));
  ASSERT_TRUE(ends_with_link());
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << key_of(ct.error().code) << ct.error().where << ct.error().detail;
  EXPECT_EQ(ct->slices, 3u);
}

TEST_F(Dicom, StoredValuesBecomeCtNumbersSliceBySlice) {
  for (int n = 0; n < 2; ++n) {
    DicomWish w = slice(n);
    w.slope = n == 0 ? 2.0 : 1.0;
    w.intercept = -1024.0;
    w.values[0] = -5;
    put(std::to_string(n), w);
  }
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct);
  EXPECT_EQ(at(ct->image, 2, 1, 0), -1034.0f);
  EXPECT_EQ(at(ct->image, 2, 1, 1), -1029.0f);
  EXPECT_EQ(ct->image.kind, ImageKind::grey);
}

TEST_F(Dicom, ANumberWithACommaIsNoneAndNotItsWholePart) {
  DicomWish wish = slice(0);
  wish.slope = 2.5;
  const auto read = [&](const std::string& from, const std::string& to) {
    std::string bytes = dicom_file(wish);
    bytes.replace(bytes.find(from), from.size(), to);
    write_text(folder / "one.dcm", bytes);
    return read_dicom(folder / "one.dcm", {});
  };
  const auto sound = read("2.5 ", "2.5 ");
  ASSERT_TRUE(sound);
  EXPECT_TRUE(sound->image.spacing_known);
  const auto spaced = read("0.3\\0.2", "1,3\\1,2");
  ASSERT_TRUE(spaced);
  EXPECT_FALSE(spaced->image.spacing_known);
  const auto scaled = read("2.5 ", "2,5 ");
  ASSERT_FALSE(scaled);
  EXPECT_EQ(key_of(scaled.error().code), "bad_header");
  EXPECT_EQ(scaled.error().where, "one.dcm RescaleSlope");
}

TEST_F(Dicom, AMissingOrDoubledSliceIsRefusedWithItsFile) {
  for (int n = 0; n < 6; ++n)
    if (n != 3) put("s" + std::to_string(n), slice(n));
  const auto gap = read_dicom(folder.path(), {});
  ASSERT_FALSE(gap);
  EXPECT_EQ(key_of(gap.error().code), "bad_spacing");
  EXPECT_EQ(gap.error().where, "s4 ImagePositionPatient");
  put("s3", slice(3));
  ASSERT_TRUE(read_dicom(folder.path(), {}));
  put("again", slice(3));
  EXPECT_EQ(key_of(read_dicom(folder.path(), {}).error().code), "bad_spacing");
}

TEST_F(Dicom, ASliceWhoseHeaderIsCutIsRefusedAndNotLeftOut) {
  const auto before_rows = [](const DicomWish& w) {
    const std::string bytes = dicom_file(w);
    return bytes.substr(0, bytes.find(std::string("\x28\0\x10\0US", 6)));
  };
  for (int n = 0; n < 3; ++n) put("s" + std::to_string(n), slice(n));
  const std::string whole = dicom_file(slice(3)), cut = before_rows(slice(3));
  ASSERT_LT(cut.size(), whole.size());
  write_text(folder / "s3", cut);  // the last one: no slice is missing between two others
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_FALSE(ct);
  EXPECT_EQ(ct.error().where, "s3 Rows");
  EXPECT_EQ(read_dicom(folder / "s0", {}).error().where, "s3 Rows");
  DicomWish other = slice(3);
  other.series = "9.9";
  write_text(folder / "s3", before_rows(other));
  const auto rest = read_dicom(folder.path(), {});
  ASSERT_TRUE(rest) << "of another series: " << rest.error().where;
  EXPECT_EQ(rest->slices, 3u);
}

TEST_F(Dicom, SlicesWithoutAPlaceAreAsFarApartAsTheirLocations) {
  for (int n = 0; n < 4; ++n) {
    DicomWish w = slice(n);
    w.placed = false;
    w.thickness_mm = 1.0;  // they overlap by half
    w.location_mm = 3.0 + 0.5 * n;
    put("s" + std::to_string(n), w);
  }
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << ct.error().where;
  EXPECT_NEAR(ct->image.layout.spacing_mm.z, 0.5, 1e-9);
  EXPECT_TRUE(ct->image.spacing_known && !ct->image.sides_known);
}

TEST_F(Dicom, SlicesWithoutAPlaceALocationAndAThicknessHaveAnUnknownSpacing) {
  for (int n = 0; n < 4; ++n) {
    DicomWish w = slice(n);
    w.placed = false;
    put("s" + std::to_string(n), w);
  }
  EXPECT_TRUE(read_dicom(folder.path(), {})->image.spacing_known);  // by their thickness
  for (int n = 0; n < 4; ++n) {
    DicomWish w = slice(n);
    w.placed = false;
    w.thickness_mm = 0.0;
    put("s" + std::to_string(n), w);
  }
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << ct.error().where;
  EXPECT_FALSE(ct->image.spacing_known);
}

TEST_F(Dicom, SlicesWithoutAPlaceAreAsFarApartAsTheyState) {
  const auto put_four = [&](double last_between_mm) {
    for (int n = 0; n < 4; ++n) {
      DicomWish w = slice(n);
      w.placed = false;
      w.thickness_mm = 1.0;  // they overlap by half
      w.between_mm = n < 3 ? 0.5 : last_between_mm;
      put("s" + std::to_string(n), w);
    }
  };
  put_four(0.5);
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << ct.error().where;
  EXPECT_NEAR(ct->image.layout.spacing_mm.z, 0.5, 1e-9);
  EXPECT_TRUE(ct->image.spacing_known);
  put_four(0.7);
  EXPECT_FALSE(read_dicom(folder.path(), {})->image.spacing_known) << "they do not agree";
}

TEST_F(Dicom, ASliceThatIsShiftedInItsPlaneIsRefusedWithItsFile) {
  for (int n = 0; n < 6; ++n) put("s" + std::to_string(n), slice(n));
  ASSERT_TRUE(read_dicom(folder.path(), {}));
  DicomWish w = slice(3);
  w.position.x += 0.05;  // a quarter of a pixel
  put("s3", w);
  const auto shifted = read_dicom(folder.path(), {});
  ASSERT_FALSE(shifted);
  EXPECT_EQ(key_of(shifted.error().code), "bad_spacing");
  EXPECT_EQ(shifted.error().where, "s3 ImagePositionPatient");
}

TEST_F(Dicom, AnOrientationThatIsNoneAndAPlaceThatOneSliceLacksAreRefused) {
  for (int n = 0; n < 4; ++n) put("s" + std::to_string(n), slice(n));
  DicomWish w = slice(2);
  w.placed = false;
  put("s2", w);
  const auto lacking = read_dicom(folder.path(), {});
  ASSERT_FALSE(lacking);
  EXPECT_EQ(key_of(lacking.error().code), "bad_header");
  EXPECT_EQ(lacking.error().where, "s2 ImagePositionPatient");
  for (const std::array<double, 6>& orientation : {std::array{2.0, 0.0, 0.0, 0.0, 1.0, 0.0}, std::array{1.0, 0.0, 0.0, 0.6, 0.8, 0.0}}) {
    w = slice(2);
    w.orientation = orientation;
    put("s2", w);
    const auto skewed = read_dicom(folder / "s2", {});
    ASSERT_FALSE(skewed);
    EXPECT_EQ(key_of(skewed.error().code), "bad_orientation");
    EXPECT_EQ(skewed.error().where, "s2 ImageOrientationPatient");
    // Nor is the rest of the folder a series without it.
    for (const int n : {0, 2, 3}) {
      for (int i = 0; i < 4; ++i) {
        w = slice(i);
        if (i == n) w.orientation = orientation;
        put("s" + std::to_string(i), w);
      }
      const auto whole = read_dicom(folder.path(), {});
      ASSERT_FALSE(whole) << n;
      EXPECT_EQ(whole.error().where, "s" + std::to_string(n) + " ImageOrientationPatient");
    }
    put("s3", slice(3));
  }
}

TEST_F(Dicom, ASeriesWithoutAnyOrientationIsNoneOfAFolderThatHasAnother) {
  for (int n = 0; n < 4; ++n) put("a" + std::to_string(n), slice(n));
  for (int n = 0; n < 6; ++n) {
    DicomWish w = slice(n);
    w.series = "9.9";
    w.orientation = {};
    put("b" + std::to_string(n), w);
  }
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct) << ct.error().where;
  EXPECT_EQ(ct->series, 2u);
  EXPECT_EQ(ct->slices, 4u);
  EXPECT_EQ(key_of(read_dicom(folder / "b0", {}).error().code), "bad_orientation");
}

TEST_F(Dicom, ReadsTheLargestOfSeveralSeriesAndReportsIt) {
  for (int n = 0; n < 4; ++n) put("a" + std::to_string(n), slice(n));
  DicomWish scout = slice(0);
  scout.series = "9.9";
  put("scout", scout);
  write_text(folder / "README.txt", "not a slice");
  const auto ct = read_dicom(folder.path(), {});
  ASSERT_TRUE(ct);
  EXPECT_EQ(ct->series, 2u);
  EXPECT_EQ(ct->slices, 4u);
  const auto other = read_dicom(folder / "scout", {});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->slices, 1u);
}

TEST_F(Dicom, NothingAboutThePatientLeavesTheReader) {
  for (int n = 0; n < 8; ++n) {
    DicomWish w = slice(n);
    w.columns = w.rows = 8;
    w.patient = "Secret^Name";
    w.values = values_of({8, 8, 1}, [](IVec3 v) { return v.x > 1 && v.x < 6 && v.y > 1 && v.y < 6 ? 1000 : 0; });
    put("p" + std::to_string(n), w);
  }
  ImageImport what;
  what.path = folder.path();
  what.tissues.thresholds = {{500.0, Tissue::dentine}};
  std::vector<ImportRemark> remarks;
  const auto v = import_image(what, {}, &remarks);
  ASSERT_TRUE(v) << key_of(v.error().code) << v.error().where;
  EXPECT_TRUE(v->names.empty());
  ASSERT_FALSE(remarks.empty());
  EXPECT_EQ(remarks[0].code, RemarkCode::identity_left_out);
  for (const ImportRemark& r : remarks) EXPECT_TRUE(r.subject.empty() && r.code != RemarkCode::sides_assumed) << key_of(r.code);
  for (const std::string& text : {std::string("cut"), std::string("short")}) {
    DicomWish w = slice(20);
    w.patient = "Secret^Name";
    w.values.resize(text == "cut" ? 1 : 5);
    put("bad", w);
    const auto r = read_dicom(folder / "bad", {});
    ASSERT_FALSE(r);
    EXPECT_EQ((r.error().where + r.error().detail).find("Secret"), std::string::npos);
  }
}

TEST_F(Dicom, SlicesPackedWithoutLossAreThoseThatWerePacked) {
  // Runs, single values, both ends of the range and a step of 32768, which JPEG codes without bits of its own.
  const auto values = values_of({40, 30, 1}, [](IVec3 v) {
    if (v.y < 8) return 5;
    return v.x % 7 == 0 ? (v.y % 2 ? 32767 : -32768) : v.x == 3 ? 0 : 37 * v.x - 900 * (v.y % 5);
  });
  for (const char* transfer : {kRleLossless, kJpegLossless}) {
    const TempFolder packed;
    for (int n = 0; n < 3; ++n) {
      DicomWish w = slice(n);
      w.columns = 40;
      w.rows = 30;
      w.intercept = -1000.0;
      w.transfer = transfer;
      w.frame = transfer == kRleLossless ? rle_frame(values) : jpeg_lossless_frame(values, w.columns, w.rows);
      write_text(packed / std::to_string(n), dicom_file(w));
    }
    const auto ct = read_dicom(packed.path(), {});
    ASSERT_TRUE(ct) << transfer << " " << key_of(ct.error().code) << ct.error().where << ct.error().detail;
    EXPECT_EQ(ct->slices, 3u);
    for (int z = 0; z < 3; ++z)
      for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)  // left-posterior to right-anterior
          ASSERT_EQ(at(ct->image, 39 - x, 29 - y, z), static_cast<float>(values[static_cast<std::size_t>(40 * y + x)]) - 1000.0f)
              << transfer << " " << x << " " << y;
  }
}

TEST_F(Dicom, APackedSliceThatIsCutOrClaimsMoreThanItCanHoldIsRefused) {
  DicomWish w = slice(0);
  w.columns = w.rows = 32;
  const auto values = values_of({32, 32, 1}, [](IVec3 v) { return v.x * v.y; });
  w.transfer = kRleLossless;
  w.frame = rle_frame(values).substr(0, 100);
  put("cut", w);
  EXPECT_FALSE(read_dicom(folder / "cut", {}));
  w.transfer = kJpegLossless;
  w.frame = jpeg_lossless_frame(values, 32, 32).substr(0, 60);
  put("cut", w);
  EXPECT_FALSE(read_dicom(folder / "cut", {}));
  // A few hundred bytes whose header states 2000 x 2000 pixels.
  w.series = "1.2.4";
  w.frame = jpeg_lossless_frame(values, 32, 32);
  w.columns = w.rows = 2000;
  put("claims", w);
  const auto claims = read_dicom(folder / "claims", {});
  ASSERT_FALSE(claims);
  EXPECT_EQ(key_of(claims.error().code), "truncated");
}

TEST_F(Dicom, PicturesPackedWithLossAndOtherFilesAreRefusedByTheirTransferSyntax) {
  DicomWish w = slice(0);
  w.transfer = "1.2.840.10008.1.2.4.51";  // JPEG extended
  put("jpeg", w);
  const auto r = read_dicom(folder / "jpeg", {});
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().where, "jpeg TransferSyntaxUID");
  write_text(folder / "text.dcm", "hello");
  EXPECT_FALSE(read_dicom(folder / "text.dcm", {}));
  EXPECT_EQ(read_dicom(folder / "none", {}).error().code, ImportError::missing_file);
  const TempFolder empty;
  EXPECT_EQ(read_dicom(empty.path(), {}).error().code, ImportError::unknown_format);
}

}  // namespace
}  // namespace cusp::test

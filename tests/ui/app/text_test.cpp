// Text of codes.

#include <gtest/gtest.h>

#include <QDateTime>
#include <set>

#include "scenarios/format/keys.h"
#include "scenarios/grading/grader.h"
#include "scenarios/operators/single_fault.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/text/exchange_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/incident_text.h"
#include "ui/text/names.h"
#include "ui/text/plain.h"
#include "ui/widgets/format.h"

namespace cusp::test {
namespace {

template <class Code, class Failure>
void each_code_has_its_own_text(int codes) {
  std::set<QString> messages;
  for (int i = 0; i < codes; ++i) {
    const Message t = describe(Failure{static_cast<Code>(i), "the/place", {}});
    EXPECT_FALSE(t.what.isEmpty()) << i;
    EXPECT_TRUE(t.what.endsWith(u'.')) << t.what.toStdString();
    EXPECT_FALSE(t.line().contains(u'%')) << t.line().toStdString();
    messages.insert(t.line());
  }
  EXPECT_GE(static_cast<int>(messages.size()), codes - 10);  // eleven kinds of "not known" share one sentence with another place
}

TEST(Sentences, every_code_of_every_module_has_text) {
  each_code_has_its_own_text<StorageError, StorageFailure>(static_cast<int>(StorageError::clock_ahead) + 1);
  each_code_has_its_own_text<FormatError, FormatFailure>(static_cast<int>(FormatError::unwritable) + 1);
  each_code_has_its_own_text<ImportError, ImportFailure>(static_cast<int>(kImportErrors));
  each_code_has_its_own_text<PortError, PortFailure>(static_cast<int>(PortError::io) + 1);
  for (int i = 0; i <= static_cast<int>(SessionError::driver_silent); ++i) {
    EXPECT_FALSE(describe(SessionFailure{static_cast<SessionError>(i), "place"}).what.isEmpty());
  }
}

TEST(Sentences, a_driver_that_does_not_come_back_is_named_as_such) {
  const Message t = describe(SessionFailure{SessionError::device, "Novint Falcon", std::string(kStandsStill), PortError::io});
  EXPECT_TRUE(t.what.contains(QStringLiteral("driver of the device stands still"))) << t.what.toStdString();
  EXPECT_TRUE(t.more.contains(QStringLiteral("Novint Falcon"))) << t.more.toStdString();
}

TEST(Sentences, an_operator_with_one_fault_is_named_with_the_fault_and_its_size) {
  std::set<QString> names;
  for (const SingleFaultRow& row : single_faults())
    for (const FaultSize size : {FaultSize::small, FaultSize::medium, FaultSize::large}) {
      const QString name = operator_name(key_of(SizedFault{row.fault, size}));
      EXPECT_FALSE(name.contains(u'_')) << name.toStdString();
      names.insert(name);
    }
  EXPECT_EQ(names.size(), 3 * single_faults().size());
  EXPECT_TRUE(operator_name("too_deep:large").startsWith(QStringLiteral("Reference operator with one fault: too deep, ")));
  EXPECT_EQ(operator_name("somebody").toStdString(), "somebody");
}

TEST(Sentences, what_is_wrong_with_a_record_names_the_time_as_the_audit_log_shows_it) {
  const QDateTime when(QDate(2026, 7, 20), QTime(10, 14));
  const ChainFinding finding{.table = "people", .at_utc_us = when.toMSecsSinceEpoch() * 1000};
  const QString text = finding_text(finding);
  EXPECT_TRUE(text.contains(QStringLiteral("in the audit log since ") + format_date_time_zone(when))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("10:14"))) << text.toStdString();
  const QString entry = finding_text({.table = "audit_log", .row = 2});
  EXPECT_TRUE(entry.contains(QStringLiteral("audit_log, row 3"))) << "as the log's page counts; " << entry.toStdString();
}

TEST(Sentences, a_lock_is_over_at_the_second_that_its_message_names) {
  const QDateTime half_past(QDate(2026, 7, 20), QTime(10, 14, 30, 500));
  const auto said = [](const QDateTime& until) {
    return describe(StorageFailure{StorageError::locked, "sign_in", std::to_string(until.toMSecsSinceEpoch() * 1000)}).line();
  };
  EXPECT_TRUE(said(half_past).contains(QStringLiteral("10:14:31"))) << said(half_past).toStdString();
  EXPECT_TRUE(said(half_past.addMSecs(-500)).contains(QStringLiteral("10:14:30")));
}

TEST(Sentences, a_clock_in_doubt_is_named_with_its_day_and_that_of_the_newest_record) {
  const auto utc_us = [](const QDate& day) { return std::to_string(QDateTime(day, QTime(12, 0)).toMSecsSinceEpoch() * 1000); };
  const StorageFailure doubt{StorageError::clock_ahead, "clock", utc_us(QDate(2026, 5, 3)) + ' ' + utc_us(QDate(2031, 11, 27))};
  EXPECT_EQ(describe(doubt).line().toStdString(), "The clock may be wrong. This computer’s clock says 27 November 2031. The newest attempt or account is of 3 May 2026. Nothing was changed.");
  const StorageFailure since{StorageError::clock_ahead, "pause", doubt.detail + ' ' + utc_us(QDate(2031, 11, 20))};
  EXPECT_EQ(describe(since).line().toStdString(),
            "The clock may be wrong. This computer’s clock says 27 November 2031. Nothing was recorded from 3 May 2026 to 20 November 2031. "
            "If the clock is wrong now, or was before, attempts and accounts are younger than their dates. Nothing was changed.");
}

TEST(Sentences, why_a_device_may_be_late_is_reported_with_a_way_out) {
  RealtimeGrant grant;
  grant.level = RealtimeLevel::rtkit;
  grant.refusal = RealtimeRefusal::none;
  EXPECT_EQ(describe(grant).line().toStdString(), "The device goes before other programs.");
  grant.level = RealtimeLevel::normal;
  grant.refusal = RealtimeRefusal::no_service;
  const QString missing = describe(grant).more;
  EXPECT_TRUE(missing.contains("rtkit"));
  grant.refusal = RealtimeRefusal::not_permitted;
  EXPECT_NE(describe(grant).more, missing);
  EXPECT_FALSE(describe(RealtimeGrant{}).what.isEmpty());
}

TEST(Sentences, a_failed_attempt_names_its_cause_not_its_consequence) {
  const SessionFailure full{SessionError::recording_failed, "/data/cusp.db", {}, StorageError::disk_full};
  EXPECT_EQ(describe(full).what.toStdString(), "The disk is full.");
}

TEST(Sentences, a_newer_database_is_refused_by_name_and_stays_as_it_is) {
  const QString line = describe(StorageFailure{StorageError::newer_schema, "/data/cusp.db"}).line();
  EXPECT_TRUE(line.contains(QStringLiteral("/data/cusp.db")));
  EXPECT_TRUE(line.contains(QStringLiteral("left as it is")));
}

TEST(Sentences, a_tilted_handpiece_is_named_where_no_bur_fits) {
  EXPECT_FALSE(describe(OperatorCutError::no_path, 0).line().contains(QStringLiteral("tilted")));
  const QString tilted = describe(OperatorCutError::no_path, 20).line();
  EXPECT_TRUE(tilted.contains(QStringLiteral("while the handpiece is tilted by"))) << tilted.toStdString();
  EXPECT_TRUE(tilted.contains(QStringLiteral("20"))) << tilted.toStdString();
}

TEST(Sentences, nobody_is_shouted_at_or_blamed) {
  for (int i = 0; i <= static_cast<int>(StorageError::clock_ahead); ++i) {
    const QString line = describe(StorageFailure{static_cast<StorageError>(i), "x"}).line().toLower();
    for (const char* term : {"!", "please", "invalid", "error", "oops", "sorry"}) {
      EXPECT_FALSE(line.contains(QLatin1String(term))) << line.toStdString();
    }
  }
}

TEST(Sentences, what_earns_full_points_reads_as_dentists_say_it) {
  const auto wanted = [](const char* metric, Bands bands) {
    QString text = wanted_text({metric, 10, bands});
    for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
    return text.replace(QChar(0x00A0), u' ').toStdString();
  };
  EXPECT_EQ(wanted("depth_mean", {1.2, 1.4, 1.5, 2.0, 2.2, 2.6}), "1.5 to 2 mm");
  EXPECT_EQ(wanted("target_removed", {80, 95, 99, 100, 100, 100}), "99 % or more");
  EXPECT_EQ(wanted("overcut_beyond_floor", {0, 0, 0, 0.3, 1, 3}), "up to 0.3 mm³");
  EXPECT_EQ(wanted("contact_broken", {0, 0.5, 1, 1, 1, 1}), "yes");
  EXPECT_EQ(wanted("contact_broken", {0, 0, 0, 0, 0.5, 1}), "no");
  EXPECT_EQ(wanted("contact_broken", {0, 0, 0, 1, 1, 1}), "yes or no");
}

TEST(Sentences, a_measurement_of_yes_or_no_is_shown_without_a_number) {
  const Measure open{"contact_broken", true, 1, 1, "", {}}, closed{"contact_broken", true, 0, 0, "", {}};
  EXPECT_EQ(metric_name("contact_broken").toStdString(), "Contact open");
  EXPECT_EQ(measure_text(open).toStdString(), "yes");
  EXPECT_EQ(measure_value(closed).toStdString(), "no");
  EXPECT_TRUE(measure_uncertainty(open).isEmpty());
  for (const MetricKey& metric : kMetricKeys) EXPECT_EQ(is_yes_or_no(std::string(metric.key)), metric.unit.empty()) << metric.key;
}

TEST(Sentences, reasons_name_value_limit_and_what_lies_between) {
  QString text = reason_text(test::sample_grade(70).criteria[1]);
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  EXPECT_EQ(text.replace(QChar(0x00A0), u' ').toStdString(), "2.41 mm, 0.41 mm deeper than 2 mm");
}

std::string reason(CriterionGrade grade) {
  QString text = reason_text(grade);
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}

TEST(Sentences, what_was_too_little_or_too_much_is_shown_with_what_earns_full_points) {
  CriterionGrade g;
  const auto set = [&](const char* id, const char* unit, const char* code, double value, double limit) {
    g.id = id;
    g.measure.unit = unit;
    g.reason_code = code;
    g.reason_args = {{"value", value}, {"limit", limit}};
  };
  set("target_removed", "%", "too_little", 0.2, 97);
  EXPECT_EQ(reason(g), "0.2 % removed; full points from 97 %");
  set("target_removed", "%", "too_little", 96.97, 97);
  EXPECT_EQ(reason(g), "96.97 % removed; full points from 97 %");  // never "97.0 %; from 97 %"
  set("depth_mean", "mm", "too_deep", 1.954, 1.95);
  EXPECT_EQ(reason(g), "1.954 mm, 0.004 mm deeper than 1.95 mm");  // never "0.00 mm deeper"
  set("remaining_over_pulp", "mm", "too_little", 0.4, 1);
  EXPECT_EQ(reason(g), "0.40 mm; full points from 1 mm");
  set("overcut_beyond_side", "mm3", "too_much", 2.5, 0.3);
  EXPECT_EQ(reason(g), "2.50 mm³; full points up to 0.3 mm³");
  set("contact_broken", "", "too_little", 0, 1);
  EXPECT_EQ(reason(g), "no; full points for yes");
  set("contact_broken", "", "too_much", 1, 0);
  EXPECT_EQ(reason(g), "yes; full points for no");
}

TEST(Sentences, little_drilled_is_shown_to_the_tenth_and_advised_about_by_the_target_alone) {
  CriterionGrade g;
  g.id = "overcut_beyond_floor";
  g.reason_code = "little_drilled";
  g.reason_args = {{"share", 4.3 / 97}, {"lost", 14.335}};
  EXPECT_EQ(reason(g), "Counts for 4.4 %, because target is left");
  g.reason_args["share"] = 0.0679;
  EXPECT_EQ(reason(g), "Counts for 6.8 %, because target is left");
  g.reason_args["share"] = 87.3 / 97;
  EXPECT_EQ(reason(g), "Counts for 90 %, because target is left");
  g.reason_args["share"] = 96.999 / 97;
  EXPECT_EQ(reason(g), "Counts for 99.9 %, because target is left");  // points are missing
  EXPECT_TRUE(advice_text(g).isEmpty());
}

TEST(Sentences, advice_about_a_clearance_names_no_length_that_the_exercise_does_not_ask_for) {
  CriterionGrade g;
  g.id = "clearance_buccal_middle";
  g.reason_code = "too_little";
  EXPECT_FALSE(advice_text(g).contains(QStringLiteral("millimetre"))) << advice_text(g).toStdString();
}

TEST(Sentences, one_point_is_singular_and_fractions_are_not) {
  CriterionGrade g;
  g.id = "time";
  for (const auto& [lost, text] : {std::pair{1.0, "Time: 1 point lost"}, std::pair{1.5, "Time: 1.5 points lost"},
                                   std::pair{0.5, "Time: 0.5 points lost"}, std::pair{1.04, "Time: 1 point lost"},
                                   std::pair{6.0, "Time: 6 points lost"}}) {
    EXPECT_EQ(lost_text(g, lost).toStdString(), text);
  }
}

std::string bare(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}

TEST(Sentences, a_failure_about_a_person_names_the_number_and_never_the_file) {
  const std::string file = "/var/lib/cusp/school.db";
  const auto line = [&](StorageError code, const char* where, Secret asked, const std::string& detail = {}) {
    return bare(describe_account({code, where, detail}, QStringLiteral("20267314"), asked).line());
  };
  EXPECT_EQ(line(StorageError::duplicate, file.c_str(), Secret::pin, "UNIQUE constraint failed: people.number"),
            "The number 20267314 is taken. Nothing was changed. Choose another number.");
  EXPECT_EQ(line(StorageError::not_found, "people", Secret::password), "There is no account 20267314. Nothing was changed.");
  EXPECT_EQ(line(StorageError::disabled, "sign_in", Secret::pin),
            "The account 20267314 is switched off. Ask an administrator to switch it on again.");
  EXPECT_EQ(line(StorageError::disabled, "actor", Secret::pin), "Your account is switched off. Ask an administrator to switch it on again.")
      << "not that of the person who is edited";
  const QDateTime until(QDate(2026, 11, 20), QTime(10, 14, 30));
  EXPECT_EQ(line(StorageError::locked, "sign_in", Secret::pin, std::to_string(until.toMSecsSinceEpoch() * 1000)),
            "Too many wrong tries for 20267314. Signing in is open again at 10:14:30.");
  for (const StorageError code : {StorageError::duplicate, StorageError::not_found, StorageError::disabled, StorageError::locked,
                                  StorageError::wrong_password, StorageError::weak_password}) {
    for (const Secret asked : {Secret::password, Secret::pin}) {
      EXPECT_EQ(line(code, file.c_str(), asked).find("school.db"), std::string::npos) << static_cast<int>(code);
    }
  }
  // Without an account the file is not named either.
  EXPECT_EQ(bare(describe(StorageFailure{StorageError::duplicate, file, "UNIQUE constraint failed"}).line()),
            "This number or name is taken. Nothing was changed.");
}

TEST(Sentences, what_another_program_left_behind_is_named_as_that) {
  EXPECT_EQ(bare(describe(StorageFailure{StorageError::duplicate, "cusp.db-wal", "log"}).line()),
            "The log of other records lies there. cusp.db-wal belongs to records that were moved away. Move it beside them, or choose "
            "another place with --db.");
  EXPECT_EQ(bare(describe_exchange_failure({StorageError::duplicate, "results.cusp", "finished"}, QStringLiteral("results.cusp")).line()),
            "An earlier file of this name was interrupted. results.cusp is now finished. Choose another name for a newer one.");
}

TEST(Sentences, a_pin_is_called_a_pin_and_a_password_a_password) {
  const auto line = [](StorageError code, const char* where, Secret asked) {
    return describe_account({code, where, {}}, QStringLiteral("7"), asked).line();
  };
  for (const StorageError code : {StorageError::wrong_password, StorageError::weak_password}) {
    EXPECT_TRUE(line(code, "sign_in", Secret::pin).contains(QStringLiteral("PIN")));
    EXPECT_FALSE(line(code, "sign_in", Secret::pin).contains(QStringLiteral("assword")));
    EXPECT_TRUE(line(code, "sign_in", Secret::password).contains(QStringLiteral("assword")));
    EXPECT_FALSE(line(code, "sign_in", Secret::password).contains(QStringLiteral("PIN")));
  }
  // Storage reports which of the two was too weak, whatever was asked.
  EXPECT_EQ(describe(StorageFailure{StorageError::weak_password, "pin"}).what.toStdString(), "A PIN has exactly six digits.");
}

TEST(Sentences, a_table_of_the_records_is_never_named) {
  for (const char* table : {"people", "sessions", "scenario_versions", "blobs", "trace_chunks", "cohort_students"}) {
    const QString line = describe(StorageFailure{StorageError::not_found, table, "0199"}).line();
    EXPECT_FALSE(line.contains(QLatin1String(table))) << line.toStdString();
    EXPECT_TRUE(line.contains(QStringLiteral("0199"))) << line.toStdString();
  }
}

TEST(Sentences, a_full_disk_is_shown_only_where_the_disk_is_full) {
  const QString failed = describe(StorageFailure{StorageError::io, "/cache/tooth.nrrd", "Permission denied"}).line();
  EXPECT_FALSE(failed.contains(QStringLiteral("full"))) << failed.toStdString();
  EXPECT_TRUE(failed.contains(QStringLiteral("Permission denied"))) << failed.toStdString();
  const QString memory = describe(StorageFailure{StorageError::out_of_memory, "memory"}).line();
  EXPECT_TRUE(memory.contains(QStringLiteral("memory to check a password"))) << memory.toStdString();
}

TEST(Sentences, a_place_for_a_database_that_admits_no_file_is_not_called_missing) {
  const auto line = [](StorageError code, const char* detail) {
    QString text = describe(StorageFailure{code, "/sys/cusp.db", detail}).line();
    for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
    return text.toStdString();
  };
  EXPECT_EQ(line(StorageError::read_only, "new file"),
            "The database cannot be made there. No file can be made at /sys/cusp.db. Choose another place with --db.");
  EXPECT_EQ(line(StorageError::not_found, "folder"),
            "The database’s folder is not there. There is no folder /sys/cusp.db. Make it, or choose another place with "
            "--db.");
}

TEST(Sentences, a_backup_with_another_number_of_attempts_is_called_damaged) {
  const Message message = describe(StorageFailure{StorageError::corrupt, "/backups/monday", "sessions"});
  EXPECT_EQ(message.what.toStdString(), "The backup is damaged.");
  EXPECT_TRUE(message.more.contains(QStringLiteral("/backups/monday"))) << message.more.toStdString();
  EXPECT_TRUE(message.more.contains(QStringLiteral("number of attempts"))) << message.more.toStdString();
}

TEST(Sentences, a_narrow_isthmus_is_to_be_widened_and_a_wide_one_to_be_compared_first) {
  CriterionGrade g;
  g.id = "isthmus_width";
  g.reason_code = "too_little";
  EXPECT_TRUE(advice_text(g).startsWith(QStringLiteral("Widen"))) << advice_text(g).toStdString();
  g.reason_code = "too_much";
  EXPECT_TRUE(advice_text(g).contains(QStringLiteral("before you widen"))) << advice_text(g).toStdString();
}

TEST(Sentences, advice_leads_the_way_that_the_measure_is_off) {
  CriterionGrade g;
  const auto advice = [&g](const char* metric, const char* reason) {
    g.id = metric;
    g.reason_code = reason;
    return advice_text(g);
  };
  for (const char* metric : {"remaining_over_pulp", "ridge_mesial", "ridge_distal", "contact_broken"}) {
    EXPECT_FALSE(advice(metric, "too_much").isEmpty()) << metric;
    EXPECT_NE(advice(metric, "too_much"), advice(metric, "too_little")) << metric;
  }
  EXPECT_FALSE(advice("remaining_over_pulp", "too_much").contains(QStringLiteral("Keep away")));
  EXPECT_TRUE(advice("contact_broken", "too_little").startsWith(QStringLiteral("Open the box")));
  EXPECT_TRUE(advice("clearance_gingival", "too_little").startsWith(QStringLiteral("Lower the gingival floor")));
  EXPECT_TRUE(advice("clearance_gingival", "too_much").startsWith(QStringLiteral("Keep the gingival floor higher")));
  for (const char* metric : {"force_peak", "force_mean"}) EXPECT_TRUE(advice(metric, "too_little").isEmpty()) << metric;
  EXPECT_TRUE(advice("time", "too_little").startsWith(QStringLiteral("Take more time")));
  EXPECT_NE(advice("time", "too_little"), advice("time", "too_much"));
}

TEST(Sentences, every_metric_and_tissue_has_a_name) {
  for (const char* metric : {"target_removed", "overcut_leeway_floor", "overcut_leeway_side", "overcut_beyond_floor",
                             "overcut_beyond_side", "uncut_remainder", "depth_least", "depth_mean", "depth_most",
                             "removed_enamel", "removed_carious_dentine", "removed_16", "remaining_over_pulp", "time",
                             "force_peak", "force_mean", "pulp_exposure"}) {
    EXPECT_NE(metric_name(metric).toStdString(), metric);
  }
  for (const MetricKey& metric : kMetricKeys) {
    EXPECT_NE(metric_name(std::string(metric.key)).toStdString(), metric.key);
  }
  EXPECT_EQ(metric_unit("isthmus_width").toStdString(), "mm");
  EXPECT_EQ(metric_unit("removed_16").toStdString(), "mm3");
  EXPECT_EQ(metric_unit("unknown").toStdString(), "");
  for (std::size_t i = 0; i < kTissueKeys.size(); ++i) EXPECT_FALSE(tissue_name(static_cast<Tissue>(i)).isEmpty());
}

TEST(Text, OneOfSeveralTargetsIsNamedByItsTitleElseByItsName) {
  Region whole;
  whole.kind = RegionKind::joined;
  whole.parts.resize(2);
  whole.parts[0].name = "mesial_pit";
  whole.parts[0].title = {{"en", "Pit beside the ridge"}};
  EXPECT_EQ(metric_name("depth_mean@mesial_pit", &whole).toStdString(), "Floor depth, mean (Pit beside the ridge)");
  EXPECT_EQ(metric_name("depth_mean@mesial_pit").toStdString(), "Floor depth, mean (Mesial pit)");
  EXPECT_EQ(metric_name("depth_mean@other", &whole).toStdString(), "Floor depth, mean (Other)");
  EXPECT_EQ(metric_unit("depth_mean@mesial_pit"), QStringLiteral("mm"));
  EXPECT_EQ(metric_name("depth_mean", &whole), metric_name("depth_mean"));
}

TEST(Text, TheShareThatCountsNamesTheLeastOfSeveralTargets) {
  Rubric rubric;
  const Bands removed{80, 90, 96, 100, 100, 100}, any{0, 0, 0, 100, 100, 100};
  rubric.criteria = {{"target_removed@a", 1, removed}, {"depth_mean@a", 1, any}, {"target_removed@b", 1, removed}, {"depth_mean@b", 1, any}};
  Scenario s;
  s.rubric = rubric;
  const Grade g = scenarios::grade(s, {{"target_removed@a", true, 100, 0, "%", {}}, {"depth_mean@a", true, 2, 0, "mm", {}},
                                       {"target_removed@b", true, 24, 0, "%", {}}, {"depth_mean@b", true, 2, 0, "mm", {}}});
  EXPECT_EQ(plain(counted_text(g, rubric)), "The rest counts for less where its own target is left, the least of it for 24\u00a0%.");
}

TEST(Text, AGradeThatWasMadeAnewNamesTheCriticalEventThatOneOfBothHas) {
  GradeChanges c;
  c.evaluator_before = "8";
  c.score_before = c.score_after = 95;
  c.passed_before = true;
  c.critical = {"protected_damage"};
  EXPECT_EQ(plain(changes_text(c)), "Stored with marking 8: 95 points. What differs: Protected part damaged.");
}

TEST(Text, ThatGoesToATerminalHoldsNothingThatItObeys) {
  EXPECT_EQ(plain(QStringLiteral("\x1b[2K\rNothing was changed\n\tsince 2026\u202e\u2066.")), "\uFFFD[2K Nothing was changed  since 2026.");
  EXPECT_EQ(plain(QString(QChar(0)) + QChar(0x7F) + QChar(0x9B) + u'é'), "\uFFFD\uFFFD\uFFFDé");
}

}  // namespace
}  // namespace cusp::test

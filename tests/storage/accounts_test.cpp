#include <gtest/gtest.h>

#include <algorithm>

#include "tests/storage/accounts.h"

namespace cusp::test {
namespace {

TEST_F(AccountsTest, the_first_start_has_no_administrator_and_makes_exactly_one) {
  EXPECT_FALSE(must(accounts.has_administrator()));
  make_administrator(*store);
  EXPECT_TRUE(must(accounts.has_administrator()));
  EXPECT_EQ(code_of(accounts.create_first_administrator({.number = "b", .name = "b", .password = "correct horse"})),
            StorageError::not_allowed);
}

TEST_F(AccountsTest, the_right_password_signs_in_and_a_wrong_one_does_not) {
  const Account admin = make_administrator(*store);
  EXPECT_EQ(must(accounts.sign_in("admin", "correct horse")).id, admin.id);
  EXPECT_EQ(must(accounts.sign_in("ADMIN", "correct horse")).id, admin.id);
  EXPECT_EQ(code_of(accounts.sign_in("admin", "correct horsf")), StorageError::wrong_password);
  EXPECT_EQ(code_of(accounts.sign_in("admin", "")), StorageError::wrong_password);
  EXPECT_EQ(code_of(accounts.sign_in_with_pin("admin", "")), StorageError::other_secret);
}

TEST_F(AccountsTest, an_unknown_number_gives_the_same_failure_as_a_wrong_password) {
  make_administrator(*store);
  const auto unknown = accounts.sign_in("nobody", "correct horse");
  const auto wrong = accounts.sign_in("admin", "nonsense");
  ASSERT_FALSE(unknown);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(unknown.error().code, wrong.error().code);
  EXPECT_EQ(unknown.error().where, wrong.error().where);
  EXPECT_EQ(unknown.error().detail, wrong.error().detail);
}

TEST_F(AccountsTest, a_student_signs_in_with_a_pin) {
  const Account student = make_student(*store);
  EXPECT_EQ(must(accounts.sign_in_with_pin("20267314", "314159")).id, student.id);
  EXPECT_EQ(code_of(accounts.sign_in_with_pin("20267314", "314150")), StorageError::wrong_password);
  EXPECT_EQ(must(accounts.sign_in("20267314", "battery staple")).id, student.id);
}

TEST_F(AccountsTest, staff_have_no_pin_and_never_do_without_a_password) {
  const Actor admin = make_administrator(*store).actor();
  EXPECT_EQ(
      code_of(accounts.create(
          admin, {.number = "i", .name = "I", .role = Role::instructor, .password = "long enough", .pin = "123456"})),
      StorageError::bad_value);
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "i", .name = "I", .role = Role::instructor})),
            StorageError::weak_password);
  const Account open_student = must(accounts.create(admin, {.number = "s", .name = "S"}));
  EXPECT_EQ(code_of(accounts.set_role(admin, open_student.id, Role::administrator)), StorageError::weak_password);
  EXPECT_EQ(code_of(accounts.set_pin(admin, admin.id, "123456")), StorageError::not_found);
}

TEST_F(AccountsTest, a_secret_of_the_wrong_kind_is_no_wrong_try_and_the_failure_names_the_number) {
  const Actor admin = make_administrator(*store).actor();
  must(accounts.create(admin, {.number = "271", .name = "Omar", .pin = "271828"}));
  const auto refused = [&](const Stored<Account>& account, const std::string& number, const std::string& kind) {
    ASSERT_FALSE(account);
    EXPECT_EQ(account.error().code, StorageError::other_secret);
    EXPECT_EQ(account.error().where, number);
    EXPECT_EQ(account.error().detail, kind);
  };
  for (int i = 0; i < 9; ++i) {  // twice what would lock the account
    refused(accounts.sign_in("271", "a long password"), "271", "pin");
    refused(accounts.sign_in_with_pin("271", "letter"), "271", "pin");
    refused(accounts.sign_in_with_pin("271", "12345"), "271", "pin");
    refused(accounts.sign_in_with_pin("admin", "123456"), "admin", "password");
    refused(accounts.sign_in("admin", "123456"), "admin", "password");
  }
  EXPECT_TRUE(accounts.sign_in_with_pin("271", "271828"));
  EXPECT_TRUE(accounts.sign_in("admin", "correct horse"));
  // A malformed PIN does not reveal whether the number exists.
  refused(accounts.sign_in_with_pin("nobody", "letter"), "nobody", "pin");
  EXPECT_EQ(code_of(accounts.sign_in_with_pin("nobody", "123456")), StorageError::wrong_password);
  // A PIN that could be one is a try.
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(code_of(accounts.sign_in_with_pin("271", "000000")), StorageError::wrong_password);
  }
  EXPECT_EQ(code_of(accounts.sign_in_with_pin("271", "271828")), StorageError::locked);
}

TEST_F(AccountsTest, a_number_or_name_that_is_taken_is_named_and_not_the_file) {
  const Actor admin = make_administrator(*store).actor();
  const Actor instructor = make_instructor(*store).actor();
  const auto where = [](const auto& result) { return result ? std::string("went through") : result.error().where; };
  EXPECT_EQ(where(accounts.create(admin, {.number = "Okafor", .name = "x"})), "Okafor");
  EXPECT_EQ(where(accounts.rename(admin, instructor.id, "admin", "x")), "admin");
  must(store->cohorts.create(instructor, "Year 2"));
  EXPECT_EQ(where(store->cohorts.create(instructor, "year 2")), "year 2");
}

TEST_F(AccountsTest, a_disabled_account_is_refused_as_disabled_only_with_the_right_password) {
  const Actor admin = make_administrator(*store).actor();
  const Account student = make_student(*store);
  must(accounts.disable(admin, student.id));
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "battery staple")), StorageError::disabled);
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "wrong")), StorageError::wrong_password);
  must(accounts.enable(admin, student.id));
  EXPECT_TRUE(accounts.sign_in("20267314", "battery staple"));
}

TEST_F(AccountsTest, the_last_administrator_stays) {
  const Account admin = make_administrator(*store);
  EXPECT_EQ(code_of(accounts.disable(admin.actor(), admin.id)), StorageError::last_administrator);
  EXPECT_EQ(code_of(accounts.set_role(admin.actor(), admin.id, Role::student)), StorageError::last_administrator);
  const Account second = must(accounts.create(
      admin.actor(), {.number = "b", .name = "B", .role = Role::administrator, .password = "correct horse"}));
  must(accounts.disable(second.actor(), admin.id));
}

TEST_F(AccountsTest, who_was_switched_off_or_lost_the_role_at_another_window_writes_nothing_more) {
  const Actor admin = make_administrator(*store).actor(), instructor = make_instructor(*store).actor();
  const Actor second = must(accounts.create(admin, {.number = "b", .name = "B", .role = Role::administrator, .password = "correct horse"})).actor();
  const Account lena = make_student(*store);
  const ScenarioVersion version = keep(*store);
  const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
  const SessionId session = complete_session(*store, lena, version), begun = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  const auto other = open(folder / "a.db", quick(now));
  must(other->accounts.set_role(admin, second.id, Role::instructor));
  EXPECT_EQ(code_of(accounts.rename(second, lena.id, "x", "x")), StorageError::not_allowed);
  EXPECT_EQ(code_of(accounts.erase(second, lena.id)), StorageError::not_allowed);
  must(store->cohorts.create(second, "Year 3"));
  must(other->accounts.disable(admin, instructor.id));
  const auto added = store->cohorts.add(instructor, cohort, lena.id);
  EXPECT_EQ(code_of(added), StorageError::disabled);
  EXPECT_EQ(added.error().where, "actor") << "whose account it is";
  EXPECT_EQ(code_of(store->assignments.create(instructor, {.version = version.id, .cohort = cohort}, "")), StorageError::disabled);
  EXPECT_EQ(code_of(store->statements.override_points(instructor, session, "target_removed", 1, "Late.")), StorageError::disabled);
  EXPECT_EQ(code_of(store->scenarios.withdraw(instructor, version.id)), StorageError::disabled);
  EXPECT_EQ(code_of(store->grades.save(session, small_grade(), {}, instructor)), StorageError::disabled);
  EXPECT_EQ(must(store->grades.all(session)).size(), 1u);
  must(other->accounts.disable(admin, lena.id));
  EXPECT_EQ(code_of(accounts.set_password(lena.actor(), lena.id, "battery staple", "new password")), StorageError::disabled);
  must(store->sessions.interrupt(begun, "process_gone"));
  EXPECT_EQ(code_of(store->sessions.resume(begun, "student")), StorageError::disabled);
  must(other->accounts.enable(admin, lena.id));
  must(store->sessions.resume(begun, "student"));
  must(other->accounts.enable(admin, instructor.id));
  must(store->statements.comment(instructor, session, "In time."));
}

TEST_F(AccountsTest, who_was_erased_at_another_window_gets_nothing_back_from_a_list_that_is_older) {
  const Actor admin = make_administrator(*store).actor();
  const Account lena = make_student(*store);
  const auto other = open(folder / "a.db", quick(now));
  must(other->accounts.erase(admin, lena.id));
  EXPECT_EQ(code_of(accounts.rename(admin, lena.id, lena.number, lena.name)), StorageError::not_found);
  EXPECT_EQ(code_of(accounts.set_pin(admin, lena.id, "314159")), StorageError::not_found);
  EXPECT_EQ(code_of(accounts.set_password(admin, lena.id, "", "battery staple")), StorageError::not_found);
  EXPECT_EQ(code_of(accounts.set_role(admin, lena.id, Role::student)), StorageError::not_found);
  EXPECT_EQ(code_of(accounts.enable(admin, lena.id)), StorageError::not_found);
  const CohortId cohort = must(store->cohorts.create(admin, "Year 2")).id;
  EXPECT_EQ(code_of(store->cohorts.add(admin, cohort, lena.id)), StorageError::not_found);
  EXPECT_TRUE(must(store->cohorts.students(cohort)).empty());
  const Account left = must(accounts.find(lena.id));
  EXPECT_EQ(left.number, erased_number(lena.id));
  EXPECT_EQ(left.name, "–");
  EXPECT_TRUE(left.disabled);
  EXPECT_FALSE(left.has_pin || left.has_password);
}

TEST_F(AccountsTest, no_number_hides_an_account_from_the_list_or_from_being_switched_off) {
  const Actor admin = make_administrator(*store).actor();
  const Account hidden = must(accounts.create(
      admin, {.number = "erased 00000000-0000-x", .name = "B", .role = Role::administrator, .password = "correct horse"}));
  const auto listed = [&] {
    const auto all = must(accounts.list(admin));
    return std::ranges::any_of(all, [&](const Account& a) { return a.id == hidden.id; });
  };
  EXPECT_TRUE(listed()) << "it signs in";
  for (const std::string& number : {erased_number(hidden.id), "ERASED " + hidden.id.text()}) {
    const auto renamed = accounts.rename(admin, hidden.id, number, "B");
    ASSERT_EQ(code_of(renamed), StorageError::duplicate) << number;
    EXPECT_EQ(renamed.error().where, number);
  }
  EXPECT_TRUE(listed());
  must(accounts.disable(admin, hidden.id));
  EXPECT_EQ(code_of(accounts.sign_in("erased 00000000-0000-x", "correct horse")), StorageError::disabled);
  must(accounts.erase(admin, hidden.id));
  EXPECT_FALSE(listed());
}

TEST_F(AccountsTest, only_an_administrator_manages_accounts) {
  const Actor student = make_student(*store).actor();
  const Actor instructor = make_instructor(*store).actor();
  for (const Actor& actor : {student, instructor}) {
    EXPECT_EQ(code_of(accounts.create(actor, {.number = "x", .name = "x"})), StorageError::not_allowed);
    EXPECT_EQ(code_of(accounts.set_role(actor, actor.id, Role::administrator)), StorageError::not_allowed);
    EXPECT_EQ(code_of(accounts.disable(actor, student.id)), StorageError::not_allowed);
    EXPECT_EQ(code_of(accounts.rename(actor, student.id, "a", "a")), StorageError::not_allowed);
    EXPECT_EQ(code_of(accounts.set_pin(actor, student.id, "000000")), StorageError::not_allowed);
  }
  EXPECT_EQ(code_of(accounts.list(student)), StorageError::not_allowed);
  EXPECT_EQ(must(accounts.list(instructor)).size(), 2u);
}

TEST_F(AccountsTest, one_changes_ones_own_password_with_the_old_one_only) {
  const Account student = make_student(*store);
  EXPECT_EQ(code_of(accounts.set_password(student.actor(), student.id, "wrong", "new password")),
            StorageError::wrong_password);
  EXPECT_EQ(code_of(accounts.set_password(student.actor(), student.id, "battery staple", "short")),
            StorageError::weak_password);
  must(accounts.set_password(student.actor(), student.id, "battery staple", "new password"));
  EXPECT_TRUE(accounts.sign_in("20267314", "new password"));
  const Account other = make_student(*store, "2", "B");
  EXPECT_EQ(code_of(accounts.set_password(student.actor(), other.id, "battery staple", "new password")),
            StorageError::not_allowed);
  must(accounts.set_password(make_administrator(*store).actor(), other.id, "", "given by the office"));
  EXPECT_TRUE(accounts.sign_in("2", "given by the office"));
}

TEST_F(AccountsTest, a_number_is_given_once_upper_and_lower_case_alike) {
  const Actor admin = make_administrator(*store).actor();
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "Admin", .name = "x"})), StorageError::duplicate);
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "", .name = "x"})), StorageError::bad_value);
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "x", .name = ""})), StorageError::bad_value);
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "x", .name = "x", .pin = "12345"})), StorageError::weak_password);
  EXPECT_EQ(must(accounts.list(admin)).size(), 1u);
}

TEST_F(AccountsTest, limits_of_names_count_characters_whatever_their_bytes) {
  const Actor admin = make_administrator(*store).actor(), instructor = make_instructor(*store).actor();
  const auto times = [](std::size_t count, const std::string& character) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += character;
    return out;
  };
  for (const std::string character : {"n", "\xC3\xBC", "\xE6\x9D\x8E", "\xF0\xA0\xAE\xB7"}) {  // n, u umlaut, and two names of China
    const std::string number = times(kMostNumber, character), name = times(kMostName, character);
    const UserId user = must(accounts.create(admin, {.number = number, .name = name})).id;
    must(accounts.rename(admin, user, number, name));
    must(store->cohorts.create(instructor, times(kMostCohortName, character)));
    EXPECT_EQ(accounts.create(admin, {.number = number + character, .name = "x"}).error().where, "number");
    EXPECT_EQ(accounts.create(admin, {.number = "x", .name = name + character}).error().where, "name");
    EXPECT_EQ(accounts.rename(admin, user, number + character, name).error().where, "number");
    EXPECT_EQ(accounts.rename(admin, user, number, name + character).error().where, "name");
    EXPECT_EQ(code_of(store->cohorts.create(instructor, times(kMostCohortName + 1, character))), StorageError::bad_value);
  }
  EXPECT_EQ(code_of(accounts.create(admin, {.number = "x", .name = "n" + times(4 * kMostName, "\x80")})), StorageError::bad_value) << "no UTF-8";
}

TEST_F(AccountsTest, a_guest_of_an_older_program_is_in_no_list_and_cannot_sign_in) {
  const Actor admin = make_administrator(*store).actor();
  const Account guest = make_guest(*store);
  EXPECT_TRUE(guest.guest);
  EXPECT_EQ(must(accounts.list(admin)).size(), 1u);
  EXPECT_EQ(code_of(accounts.sign_in(guest.number, "")), StorageError::wrong_password);
  EXPECT_EQ(code_of(accounts.set_password(admin, guest.id, "", "long enough")), StorageError::not_found);
}

TEST_F(AccountsTest, demo_is_made_only_in_a_database_without_accounts) {
  const Account demo = must(accounts.demo_student());
  EXPECT_EQ(demo.role, Role::student);
  EXPECT_FALSE(must(accounts.has_administrator()));
  EXPECT_EQ(must(accounts.demo_student()).id, demo.id);
  EXPECT_EQ(must(accounts.sign_in("demo", "")).id, demo.id);
  EXPECT_EQ(code_of(accounts.sign_in("demo", "x")), StorageError::wrong_password);
  const Folder other;
  const auto school = open(other / "b.db");
  make_administrator(*school);
  EXPECT_EQ(code_of(school->accounts.demo_student()), StorageError::not_allowed);
}

TEST_F(AccountsTest, what_is_done_to_accounts_stands_in_the_audit_log_without_names) {
  const Account admin = make_administrator(*store);
  const Account student = make_student(*store);
  must(accounts.disable(admin.actor(), student.id));
  EXPECT_EQ(code_of(store->audit.list(student.actor(), 10)), StorageError::not_allowed);
  const auto entries = must(store->audit.list(admin.actor(), 100));
  ASSERT_EQ(entries.size(), 5u);  // key, sealing, two accounts, disabled
  EXPECT_EQ(entries[0].action, "account_disabled");
  EXPECT_EQ(entries[0].actor, admin.id);
  EXPECT_EQ(entries[0].subject, student.id.uuid);
  for (const AuditEntry& entry : entries) {
    EXPECT_EQ(entry.detail.find("Lena"), std::string::npos);
    EXPECT_EQ(entry.detail.find("20267314"), std::string::npos);
  }
  EXPECT_TRUE(must(verify_audit_log(store->context())).intact());
}

TEST_F(AccountsTest, cohorts_hold_students) {
  const Actor instructor = make_instructor(*store).actor();
  const Account student = make_student(*store);
  const Cohort cohort = must(store->cohorts.create(instructor, "Year 2, group A"));
  EXPECT_EQ(code_of(store->cohorts.create(instructor, "year 2, group a")), StorageError::duplicate);
  must(store->cohorts.add(instructor, cohort.id, student.id));
  must(store->cohorts.add(instructor, cohort.id, student.id));
  EXPECT_EQ(must(store->cohorts.list()).at(0).students, 1);
  const Cohort found = must(store->cohorts.find_name("YEAR 2, group A"));
  EXPECT_EQ(found.id, cohort.id);
  EXPECT_EQ(found.name, "Year 2, group A");
  EXPECT_EQ(found.students, 1);
  for (const char* unknown : {"", "Year 2", "Year 2, group A ", "%"}) {
    EXPECT_EQ(code_of(store->cohorts.find_name(unknown)), StorageError::not_found) << unknown;
  }
  EXPECT_EQ(must(store->cohorts.students(cohort.id)), std::vector{student.id});
  EXPECT_EQ(code_of(store->cohorts.add(instructor, cohort.id, UserId::make())), StorageError::not_found);
  const UserId other = make_student(*store, "4712", "Jonas Weber").id;
  const std::vector<UserId> with_nobody = {other, UserId::make()}, both = {student.id, other};
  EXPECT_EQ(code_of(store->cohorts.add_all(instructor, cohort.id, with_nobody)), StorageError::not_found);
  EXPECT_EQ(must(store->cohorts.students(cohort.id)).size(), 1u) << "all or none";
  must(store->cohorts.add_all(instructor, cohort.id, both));
  EXPECT_EQ(must(store->cohorts.students(cohort.id)).size(), 2u);
  EXPECT_EQ(must(store->audit.list(make_administrator(*store).actor(), 100, INT64_MAX, {.actions = {"cohort_joined"}})).size(), 2u) << "each once";
  EXPECT_EQ(code_of(store->cohorts.add(student.actor(), cohort.id, student.id)), StorageError::not_allowed);
  must(store->cohorts.remove(instructor, cohort.id, other));
  must(store->cohorts.remove(instructor, cohort.id, student.id));
  EXPECT_TRUE(must(store->cohorts.students(cohort.id)).empty());
}

}  // namespace
}  // namespace cusp::test

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>cusp::ui::AssessmentCard</name>
    <message numerus="yes">
        <source>%n attempt(s) so far</source>
        <translation>
            <numerusform>%n attempt so far</numerusform>
            <numerusform>%n attempts so far</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssessmentPage</name>
    <message numerus="yes">
        <source>Release %n result(s)?</source>
        <translation>
            <numerusform>Release %n result?</numerusform>
            <numerusform>Release %n results?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) released.</source>
        <translation>
            <numerusform>%n result released.</numerusform>
            <numerusform>%n results released.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed result(s) wait for confirmation.</source>
        <translation>
            <numerusform>%n failed result waits for confirmation.</numerusform>
            <numerusform>%n failed results wait for confirmation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssignmentForm</name>
    <message numerus="yes">
        <source>day(s) old</source>
        <translation>
            <numerusform>day old</numerusform>
            <numerusform>days old</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::AuditPage</name>
    <message numerus="yes">
        <source>Each choice was left out or halved once, with %n scripted attempt(s) each.</source>
        <translation>
            <numerusform>Each choice was left out or halved once, with %n scripted attempt each.</numerusform>
            <numerusform>Each choice was left out or halved once, with %n scripted attempts each.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::Cli</name>
    <message numerus="yes">
        <source>%n session(s) and the audit log are whole.</source>
        <translation>
            <numerusform>%n session and the audit log are whole.</numerusform>
            <numerusform>%n sessions and the audit log are whole.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The record is whole; %n tick(s) come to the same tooth and grade, bit for bit.</source>
        <translation>
            <numerusform>The record is whole; %n tick comes to the same tooth and grade, bit for bit.</numerusform>
            <numerusform>The record is whole; %n ticks come to the same tooth and grade, bit for bit.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cannot be used: %2 (and %n more)</source>
        <translation>
            <numerusform>%1 cannot be used: %2 (and %n more thing)</numerusform>
            <numerusform>%1 cannot be used: %2 (and %n more things)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n triangle(s), %2, %3 mm</source>
        <translation>
            <numerusform>%1: %n triangle, %2, %3 mm</numerusform>
            <numerusform>%1: %n triangles, %2, %3 mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n voxel(s)</source>
        <translation>
            <numerusform>%1: %n voxel</numerusform>
            <numerusform>%1: %n voxels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry/entries of the audit log are not yet in the counter beside the key.</source>
        <translation>
            <numerusform>%n entry of the audit log is not yet in the counter beside the key.</numerusform>
            <numerusform>%n entries of the audit log are not yet in the counter beside the key.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The lists are made anew from the records; %n value(s) differed.</source>
        <translation>
            <numerusform>The lists are made anew from the records; %n value differed.</numerusform>
            <numerusform>The lists are made anew from the records; %n values differed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) are restored as of %1.</source>
        <translation>
            <numerusform>%n session is restored as of %1.</numerusform>
            <numerusform>%n sessions are restored as of %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) would be erased.</source>
        <translation>
            <numerusform>%n student would be erased.</numerusform>
            <numerusform>%n students would be erased.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) are erased.</source>
        <translation>
            <numerusform>%n student is erased.</numerusform>
            <numerusform>%n students are erased.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) stay: an assessment of theirs is not released.</source>
        <translation>
            <numerusform>%n student stays: an assessment of theirs is not released.</numerusform>
            <numerusform>%n students stay: an assessment of theirs is not released.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) cannot be verified and stayed as they are, %1 first: %2</source>
        <translation>
            <numerusform>%n attempt cannot be verified and stayed as it is, %1: %2</numerusform>
            <numerusform>%n attempts cannot be verified and stayed as they are, %1 first: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) exported.</source>
        <translation>
            <numerusform>%n attempt exported.</numerusform>
            <numerusform>%n attempts exported.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 instead of %3 point(s), changed by %4: %5</source>
        <extracomment>%1: a criterion, %2: points that count, %3: measured points, %4: an examiner, %5: the reason.</extracomment>
        <translation>
            <numerusform>%1: %2 instead of %3 point, changed by %4: %5</numerusform>
            <numerusform>%1: %2 instead of %3 points, changed by %4: %5</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::CohortsPage</name>
    <message numerus="yes">
        <source>%n student(s) were in it already.</source>
        <translation>
            <numerusform>%n student was in it already.</numerusform>
            <numerusform>%n students were in it already.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Nor %n more.</source>
        <translation>
            <numerusform>Nor %n other.</numerusform>
            <numerusform>Nor %n others.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) added.</source>
        <translation>
            <numerusform>%n student added.</numerusform>
            <numerusform>%n students added.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::DepartedCard</name>
    <message numerus="yes">
        <source>%n student(s): %1</source>
        <translation>
            <numerusform>%n student: %1</numerusform>
            <numerusform>%n students: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) stay: an assessment of theirs is not released.</source>
        <translation>
            <numerusform>%n student stays: an assessment of theirs is not released.</numerusform>
            <numerusform>%n students stay: an assessment of theirs is not released.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Erase %n student(s) for good?</source>
        <translation>
            <numerusform>Erase %n student for good?</numerusform>
            <numerusform>Erase %n students for good?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) are erased.</source>
        <translation>
            <numerusform>%n student is erased.</numerusform>
            <numerusform>%n students are erased.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::Desktop</name>
    <message numerus="yes">
        <source>You were signed out after %n minute(s) without input.</source>
        <translation>
            <numerusform>You were signed out after %n minute without input.</numerusform>
            <numerusform>You were signed out after %n minutes without input.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::EditorPage</name>
    <message numerus="yes">
        <source>%n thing(s) to look at</source>
        <translation>
            <numerusform>%n thing to look at</numerusform>
            <numerusform>%n things to look at</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExerciseUse</name>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n student</numerusform>
            <numerusform>%n students</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n graded attempt(s)</source>
        <translation>
            <numerusform>%n graded attempt</numerusform>
            <numerusform>%n graded attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExercisesPage</name>
    <message numerus="yes">
        <source>%n exercise(s) cannot be read.</source>
        <translation>
            <numerusform>%n exercise cannot be read.</numerusform>
            <numerusform>%n exercises cannot be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportPage</name>
    <message numerus="yes">
        <source>%n slice(s) of a CT, in the order of their places.</source>
        <translation>
            <numerusform>%n slice of a CT.</numerusform>
            <numerusform>%n slices of a CT, in the order of their places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its folder holds %n series. Of a slice its own is taken, of a folder the largest.</source>
        <translation>
            <numerusform>Its folder holds %n series.</numerusform>
            <numerusform>Its folder holds %n series. Of a slice its own is taken, of a folder the largest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportText</name>
    <message numerus="yes">
        <source>The folder holds %n series; the one with %1 slices was read.</source>
        <translation>
            <numerusform>The folder holds %n series of %1 slices; it was read.</numerusform>
            <numerusform>The folder holds %n series; the one with %1 slices was read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n point(s) that lay in one place were joined.</source>
        <translation>
            <numerusform>In %1 %n point was joined with its neighbour.</numerusform>
            <numerusform>In %1 %n points that lay in one place were joined.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n triangle(s) too many were left out.</source>
        <translation>
            <numerusform>In %1 %n triangle too many was left out.</numerusform>
            <numerusform>In %1 %n triangles too many were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n triangle(s) were turned round.</source>
        <translation>
            <numerusform>In %1 %n triangle was turned round.</numerusform>
            <numerusform>In %1 %n triangles were turned round.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n hole(s) were closed, the widest of %2.</source>
        <translation>
            <numerusform>In %1 %n hole of %2 was closed.</numerusform>
            <numerusform>In %1 %n holes were closed, the widest of %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n voxel(s) of separate components were left out.</source>
        <translation>
            <numerusform>%n voxel of separate components was left out.</numerusform>
            <numerusform>%n voxels of separate components were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n voxel(s) of closed hollows were filled.</source>
        <translation>
            <numerusform>%n voxel of closed hollows was filled.</numerusform>
            <numerusform>%n voxels of closed hollows were filled.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::LibraryPage</name>
    <message numerus="yes">
        <source>%n exercise(s) cannot be read.</source>
        <translation>
            <numerusform>%n exercise cannot be read.</numerusform>
            <numerusform>%n exercises cannot be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open assignment(s) of this version can no longer be drilled.</source>
        <translation>
            <numerusform>%n open assignment of this version can no longer be drilled.</numerusform>
            <numerusform>%n open assignments of this version can no longer be drilled.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s)</source>
        <translation>
            <numerusform>%n exercise</numerusform>
            <numerusform>%n exercises</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::LogPage</name>
    <message numerus="yes">
        <source>Last %n day(s)</source>
        <translation>
            <numerusform>Last day</numerusform>
            <numerusform>Last %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The log is whole: %n entry(ies) hold.</source>
        <translation>
            <numerusform>The log is whole: %n entry holds.</numerusform>
            <numerusform>The log is whole: %n entries hold.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) exported.</source>
        <translation>
            <numerusform>%n entry exported.</numerusform>
            <numerusform>%n entries exported.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::MeshForm</name>
    <message numerus="yes">
        <source>%n gap(s), the widest of %1 at %2</source>
        <translation>
            <numerusform>%n gap of %1 at %2</numerusform>
            <numerusform>%n gaps, the widest of %1 at %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::PackCard</name>
    <message numerus="yes">
        <source>Nothing was changed: %n file(s), and every record of the attempt.</source>
        <translation>
            <numerusform>Nothing was changed: %n file, and every record of the attempt.</numerusform>
            <numerusform>Nothing was changed: %n files, and every record of the attempt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::PeopleImport</name>
    <message numerus="yes">
        <source>%n new account(s).</source>
        <translation>
            <numerusform>%n new account.</numerusform>
            <numerusform>%n new accounts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) have one already.</source>
        <translation>
            <numerusform>%n student has one already.</numerusform>
            <numerusform>%n students have one already.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) belong to another name and stay as they are.</source>
        <translation>
            <numerusform>%n number belongs to another name and stays as it is.</numerusform>
            <numerusform>%n numbers belong to other names and stay as they are.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) are left out; the table says why.</source>
        <translation>
            <numerusform>%n line is left out; the table says why.</numerusform>
            <numerusform>%n lines are left out; the table says why.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) made.</source>
        <translation>
            <numerusform>%n account made.</numerusform>
            <numerusform>%n accounts made.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new name(s) have an account under another number: perhaps the same person.</source>
        <translation>
            <numerusform>%n new name has an account under another number: perhaps the same person.</numerusform>
            <numerusform>%n new names have an account under another number: perhaps the same people.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::PeoplePage</name>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::Performance</name>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Last %n day(s)</source>
        <translation>
            <numerusform>Last day</numerusform>
            <numerusform>Last %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n student</numerusform>
            <numerusform>%n students</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s).</source>
        <translation>
            <numerusform>%n attempt.</numerusform>
            <numerusform>%n attempts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Median over %n attempt(s).</source>
        <translation>
            <numerusform>Median over %n attempt.</numerusform>
            <numerusform>Median over %n attempts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) exported.</source>
        <translation>
            <numerusform>%n attempt exported.</numerusform>
            <numerusform>%n attempts exported.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Median of %n student(s)</source>
        <translation>
            <numerusform>Median of %n student</numerusform>
            <numerusform>Median of %n students</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::RecordingsCard</name>
    <message numerus="yes">
        <source>%n recording(s), %1</source>
        <translation>
            <numerusform>%n recording, %1</numerusform>
            <numerusform>%n recordings, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Thin %n recording(s)?</source>
        <translation>
            <numerusform>Thin %n recording?</numerusform>
            <numerusform>Thin %n recordings?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::Report</name>
    <message numerus="yes">
        <source>Best before: %1 point(s) on %2; this attempt %3.</source>
        <translation>
            <numerusform>Best before: %1 point on %2; this attempt %3.</numerusform>
            <numerusform>Best before: %1 points on %2; this attempt %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more time</numerusform>
            <numerusform>and %n more times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Own assessment: %1 of 100 on %n rated criterion(s), measured %2</source>
        <translation>
            <numerusform>Own assessment: %1 of 100 on %n rated criterion, measured %2</numerusform>
            <numerusform>Own assessment: %1 of 100 on %n rated criteria, measured %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 instead of %3 point(s)</source>
        <translation>
            <numerusform>%1: %2 instead of %3 point</numerusform>
            <numerusform>%1: %2 instead of %3 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 instead of %2 point(s), changed by %3: %4</source>
        <extracomment>%1: points that count, %2: measured points, %3: an examiner, %4: the reason.</extracomment>
        <translation>
            <numerusform>%1 instead of %2 point, changed by %3: %4</numerusform>
            <numerusform>%1 instead of %2 points, changed by %3: %4</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::StartPage</name>
    <message numerus="yes">
        <source>Time earns no points. %1 only, %n attempt(s).</source>
        <translation>
            <numerusform>Time earns no points. %1 only, %n attempt.</numerusform>
            <numerusform>Time earns no points. %1 only, %n attempts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 only, %n attempt(s).</source>
        <translation>
            <numerusform>%1 only, %n attempt.</numerusform>
            <numerusform>%1 only, %n attempts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n assessment(s) cannot be shown.</source>
        <translation>
            <numerusform>%n assessment cannot be shown.</numerusform>
            <numerusform>%n assessments cannot be shown.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::StationPage</name>
    <message numerus="yes">
        <source>%n session(s), %1</source>
        <translation>
            <numerusform>%n session, %1</numerusform>
            <numerusform>%n sessions, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s), %1.</source>
        <translation>
            <numerusform>%n session, %1.</numerusform>
            <numerusform>%n sessions, %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) and the audit log are whole.</source>
        <translation>
            <numerusform>%n session and the audit log are whole.</numerusform>
            <numerusform>%n sessions and the audit log are whole.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s): something was changed from outside.</source>
        <translation>
            <numerusform>%n finding: something was changed from outside.</numerusform>
            <numerusform>%n findings: something was changed from outside.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::Text</name>
    <message numerus="yes">
        <source>%1: %2 point(s) lost</source>
        <translation>
            <numerusform>%1: %2 point lost</numerusform>
            <numerusform>%1: %2 points lost</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sign-in failed, %n wrong time(s) in a row</source>
        <translation>
            <numerusform>Sign-in failed, wrong once</numerusform>
            <numerusform>Sign-in failed, wrong %n times in a row</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Records backed up, %n session(s)</source>
        <translation>
            <numerusform>Records backed up, %n session</numerusform>
            <numerusform>Records backed up, %n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Audit log exported, %n entry(ies)</source>
        <translation>
            <numerusform>Audit log exported, %n entry</numerusform>
            <numerusform>Audit log exported, %n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s)</source>
        <translation>
            <numerusform>%n exercise</numerusform>
            <numerusform>%n exercises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n assignment(s)</source>
        <translation>
            <numerusform>%n assignment</numerusform>
            <numerusform>%n assignments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n statement(s) wait for their attempt; read the file again after that of the other station.</source>
        <translation>
            <numerusform>%n statement waits for its attempt; read the file again after that of the other station.</numerusform>
            <numerusform>%n statements wait for their attempt; read the file again after that of the other station.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) would be thinned: %1.</source>
        <translation>
            <numerusform>%n recording would be thinned: %1.</numerusform>
            <numerusform>%n recordings would be thinned: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) were thinned: %1.</source>
        <translation>
            <numerusform>%n recording was thinned: %1.</numerusform>
            <numerusform>%n recordings were thinned: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>self-test at most %n day(s) old</source>
        <translation>
            <numerusform>self-test at most %n day old</numerusform>
            <numerusform>self-test at most %n days old</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n statement(s) about attempts</source>
        <translation>
            <numerusform>%n statement about attempts</numerusform>
            <numerusform>%n statements about attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 point</numerusform>
            <numerusform>%1 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) went on from an old copy at the station, and stay here as they were.</source>
        <translation>
            <numerusform>%n attempt went on from an old copy at the station, and stays here as it was.</numerusform>
            <numerusform>%n attempts went on from an old copy at the station, and stay here as they were.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) exported.</source>
        <translation>
            <numerusform>%n result exported.</numerusform>
            <numerusform>%n results exported.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them failed by a critical event with enough points to pass: the gradebook sees the points alone.</source>
        <translation>
            <numerusform>%n of them failed by a critical event, though its points would pass: the gradebook sees the points alone.</numerusform>
            <numerusform>%n of them failed by a critical event, though their points would pass: the gradebook sees the points alone.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) wait for release.</source>
        <translation>
            <numerusform>%n result waits for release.</numerusform>
            <numerusform>%n results wait for release.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) have no graded attempt: %1.</source>
        <translation>
            <numerusform>%n student has no graded attempt: %1.</numerusform>
            <numerusform>%n students have no graded attempt: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) that were here have gone on.</source>
        <translation>
            <numerusform>%n attempt that was here has gone on.</numerusform>
            <numerusform>%n attempts that were here have gone on.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) made here gave the number to the office’s account of the same name; People shows both.</source>
        <translation>
            <numerusform>%n account made here gave its number to the office’s account of the same name; People shows both.</numerusform>
            <numerusform>%n accounts made here gave their numbers to the office’s accounts of the same names; People shows both.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::VolumeForm</name>
    <message numerus="yes">
        <source>%n voxel(s)</source>
        <translation>
            <numerusform>%n voxel</numerusform>
            <numerusform>%n voxels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cusp::ui::WayBack</name>
    <message numerus="yes">
        <source>%n backup(s) in %1.</source>
        <translation>
            <numerusform>%n backup in %1.</numerusform>
            <numerusform>%n backups in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It holds %n session(s). No other Cusp may run with these records.</source>
        <translation>
            <numerusform>It holds %n session. No other Cusp may run with these records.</numerusform>
            <numerusform>It holds %n sessions. No other Cusp may run with these records.</numerusform>
        </translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en_US">
<context>
    <name>cusp::ui::AgainstBefore</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Against the best before</source>
        <translation>Gegen den besten Versuch davor</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AppealPack</name>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is no appeal pack.</source>
        <translation>%1 ist keine Einspruchsakte.</translation>
    </message>
    <message>
        <source>It may have been cut off on its way. Ask for it once more.</source>
        <translation>Sie wurde vielleicht unterwegs abgeschnitten. Bitten Sie noch einmal darum.</translation>
    </message>
    <message>
        <source>The attempt and its grade are kept.</source>
        <translation>Der Versuch und seine Bewertung bleiben erhalten.</translation>
    </message>
    <message>
        <source>The attempt is too long for an appeal pack.</source>
        <translation>Der Versuch ist zu lang für eine Einspruchsakte.</translation>
    </message>
    <message>
        <source>%1 cannot be read.</source>
        <translation>%1 kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The pack cannot be written to the temporary folder: %1.</source>
        <translation>Die Akte kann nicht in den temporären Ordner geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssessmentCard</name>
    <message>
        <source>Opens %1</source>
        <translation>Öffnet %1</translation>
    </message>
    <message>
        <source>Open until %1</source>
        <translation>Offen bis %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Interrupted: continue it below</source>
        <translation>Unterbrochen: unten fortsetzen</translation>
    </message>
    <message>
        <source>Handed in: the result is not released yet</source>
        <translation>Abgegeben: das Ergebnis ist noch nicht freigegeben</translation>
    </message>
    <message>
        <source>The time is over</source>
        <translation>Die Zeit ist um</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) so far</source>
        <translation>
            <numerusform>bisher %n Versuch</numerusform>
            <numerusform>bisher %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Kandidat/in %1</translation>
    </message>
    <message>
        <source>Assessment: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
    <message>
        <source>time limit %1</source>
        <translation>Zeitgrenze %1</translation>
    </message>
    <message>
        <source>Start assessment</source>
        <translation>Prüfung beginnen</translation>
    </message>
    <message>
        <source>%1 (%2 % extra time)</source>
        <translation>%1 (%2 % Zeitzugabe)</translation>
    </message>
    <message>
        <source>Needs another device</source>
        <translation>Braucht ein anderes Gerät</translation>
    </message>
    <message>
        <source>large text</source>
        <translation>große Schrift</translation>
    </message>
    <message>
        <source>only with %1</source>
        <translation>nur mit %1</translation>
    </message>
    <message>
        <source>Needs a newer self-test</source>
        <translation>Braucht einen neueren Selbsttest</translation>
    </message>
    <message>
        <source>Runs in another window</source>
        <translation>Läuft in einem anderen Fenster</translation>
    </message>
    <message>
        <source>Interrupted: ask the invigilator</source>
        <translation>Unterbrochen: die Aufsicht fragen</translation>
    </message>
    <message>
        <source>Your assessment of this exercise is not handed in yet.</source>
        <translation>Ihre Prüfung zu dieser Übung ist noch nicht abgegeben.</translation>
    </message>
    <message>
        <source>Until then the exercise cannot be practised. Continue the assessment or hand it in on the start page.</source>
        <translation>Bis dahin ist zu dieser Übung kein Training möglich. Setzen Sie die Prüfung auf der Startseite fort, oder geben Sie sie dort ab.</translation>
    </message>
    <message>
        <source>Attempts used: %1 of %2</source>
        <translation>Verbrauchte Versuche: %1 von %2</translation>
    </message>
    <message>
        <source>Interrupted: see below</source>
        <translation>Unterbrochen: siehe unten</translation>
    </message>
    <message>
        <source>It runs in another window. Until it is handed in there, the exercise cannot be practised.</source>
        <translation>Sie läuft in einem anderen Fenster. Bis sie dort abgegeben ist, ist zu dieser Übung kein Training möglich.</translation>
    </message>
    <message>
        <source>This exercise cannot be practised now.</source>
        <translation>Diese Übung kann jetzt nicht trainiert werden.</translation>
    </message>
    <message>
        <source>Try again; if that does not help, ask your instructor. Your assignments or attempts could not be read: %1</source>
        <translation>Versuchen Sie es noch einmal; hilft das nicht, fragen Sie Ihre Lehrkraft. Ihre Zuweisungen oder Versuche konnten nicht gelesen werden: %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssessmentPage</name>
    <message>
        <source>Results of an assignment</source>
        <translation>Ergebnisse einer Zuweisung</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidatinnen und Kandidaten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Show names</source>
        <translation>Namen zeigen</translation>
    </message>
    <message>
        <source>Release results</source>
        <translation>Ergebnisse freigeben</translation>
    </message>
    <message numerus="yes">
        <source>Release %n result(s)?</source>
        <translation>
            <numerusform>%n Ergebnis freigeben?</numerusform>
            <numerusform>%n Ergebnisse freigeben?</numerusform>
        </translation>
    </message>
    <message>
        <source>Their students can then read points, criteria and remarks. Failed results that nobody has confirmed stay withheld.</source>
        <translation>Ihre Studierenden können dann Punkte, Kriterien und Bemerkungen lesen. Nicht bestandene Ergebnisse, die niemand bestätigt hat, bleiben zurückgehalten.</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) released.</source>
        <translation>
            <numerusform>%n Ergebnis freigegeben.</numerusform>
            <numerusform>%n Ergebnisse freigegeben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed result(s) wait for confirmation.</source>
        <translation>
            <numerusform>%n nicht bestandenes Ergebnis wartet auf Bestätigung.</numerusform>
            <numerusform>%n nicht bestandene Ergebnisse warten auf Bestätigung.</numerusform>
        </translation>
    </message>
    <message>
        <source>Extra time of %1</source>
        <translation>Zeitzugabe für %1</translation>
    </message>
    <message>
        <source>Gradebook</source>
        <translation>Notenbuch</translation>
    </message>
    <message>
        <source>Save the released results as a column for another system</source>
        <translation>Die freigegebenen Ergebnisse als Spalte für ein anderes System speichern</translation>
    </message>
    <message>
        <source>For Moodle</source>
        <translation>Für Moodle</translation>
    </message>
    <message>
        <source>For Canvas</source>
        <translation>Für Canvas</translation>
    </message>
    <message>
        <source>Save for the gradebook</source>
        <translation>Für das Notenbuch speichern</translation>
    </message>
    <message>
        <source>only with %1</source>
        <translation>nur mit %1</translation>
    </message>
    <message>
        <source>Large text</source>
        <translation>Große Schrift</translation>
    </message>
    <message>
        <source>Drilling screen and report at 150 % at least</source>
        <translation>Bohransicht und Bericht in mindestens 150 %</translation>
    </message>
    <message>
        <source>Keep the adjustment</source>
        <translation>Ausgleich speichern</translation>
    </message>
    <message>
        <source>for attempts that begin from now on</source>
        <translation>für Versuche, die ab jetzt beginnen</translation>
    </message>
    <message>
        <source>%1 has no adjustment.</source>
        <translation>%1 hat keinen Nachteilsausgleich.</translation>
    </message>
    <message>
        <source>%1 has %2.</source>
        <translation>%1 hat %2.</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>zurückgezogen</translation>
    </message>
    <message>
        <source>%1 is no longer in the cohort.</source>
        <translation>%1 ist nicht mehr in der Kohorte.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The adjustment of %1 was changed at another desk meanwhile.</source>
        <translation>Der Ausgleich von %1 wurde inzwischen an einem anderen Platz geändert.</translation>
    </message>
    <message>
        <source>It is shown as it is now. What you set here was not kept.</source>
        <translation>Er wird gezeigt, wie er jetzt ist. Was Sie hier eingestellt haben, wurde nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssessmentStart</name>
    <message>
        <source>Start assessment</source>
        <translation>Prüfung beginnen</translation>
    </message>
    <message>
        <source>You are candidate %1. Your name is not shown to who marks.</source>
        <translation>Sie sind Kandidat/in %1. Wer bewertet, sieht Ihren Namen nicht.</translation>
    </message>
    <message>
        <source>There is no time limit.</source>
        <translation>Es gibt keine Zeitgrenze.</translation>
    </message>
    <message>
        <source>You have %1. The clock starts with the tooth; a device fault stops it.</source>
        <translation>Sie haben %1. Die Zeit läuft, sobald der Zahn da ist; eine Störung des Geräts hält sie an.</translation>
    </message>
    <message>
        <source>Start code, from the invigilator</source>
        <translation>Startcode, von der Aufsicht</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Depth, points and advice are not shown, nor is the target on a tooth. The result comes when your examiner releases it.</source>
        <translation>Tiefe, Punkte und Hinweise werden nicht gezeigt, auf einem Zahn auch nicht das Ziel. Das Ergebnis kommt, wenn es freigegeben wird.</translation>
    </message>
    <message>
        <source>Your tooth is drawn for you; other candidates have others. It stays yours if you are interrupted.</source>
        <translation>Ihr Zahn wird für Sie gelost; andere haben andere. Nach einer Unterbrechung haben Sie denselben.</translation>
    </message>
    <message>
        <source>Continue assessment</source>
        <translation>Prüfung fortsetzen</translation>
    </message>
    <message>
        <source>Tooth and clock are as you left them.</source>
        <translation>Zahn und Uhr sind so, wie Sie sie verlassen haben.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssignmentForm</name>
    <message>
        <source>Assign an exercise</source>
        <translation>Übung zuweisen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Open from</source>
        <translation>Offen ab</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Fällig</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>beliebig viele</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuweisen</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>The invigilator says it when the assessment begins</source>
        <translation>Die Aufsicht nennt ihn, wenn die Prüfung beginnt</translation>
    </message>
    <message>
        <source>Start code</source>
        <translation>Startcode</translation>
    </message>
    <message>
        <source>An attempt with another device does not count for the assignment</source>
        <translation>Ein Versuch mit einem anderen Gerät zählt nicht für die Zuweisung</translation>
    </message>
    <message>
        <source>Devices admitted</source>
        <translation>Zugelassene Geräte</translation>
    </message>
    <message>
        <source>Self-test of the device, at most</source>
        <translation>Selbsttest des Geräts, höchstens</translation>
    </message>
    <message>
        <source>Staff test a Falcon on the page Device. Devices without a self-test then do not start it.</source>
        <translation>Das Personal testet einen Falcon auf der Seite Gerät. Geräte ohne Selbsttest starten die Prüfung dann nicht.</translation>
    </message>
    <message numerus="yes">
        <source>day(s) old</source>
        <translation>
            <numerusform>Tag alt</numerusform>
            <numerusform>Tage alt</numerusform>
        </translation>
    </message>
    <message>
        <source>Days since the self-test</source>
        <translation>Tage seit dem Selbsttest</translation>
    </message>
    <message>
        <source>Another tooth for each candidate</source>
        <translation>Für jede Person ein anderer Zahn</translation>
    </message>
    <message>
        <source>Of the same number, with its target fitted to it. The session keeps which tooth it was.</source>
        <translation>Mit derselben Nummer und einem Ziel, das ihm angepasst ist. Der Versuch hält fest, welcher Zahn es war.</translation>
    </message>
    <message>
        <source>Its title or briefing was edited: figures in them stay those of the exercise’s own tooth.</source>
        <translation>Titel oder Aufgabe wurden bearbeitet: Zahlen darin bleiben die des eigenen Zahns der Übung.</translation>
    </message>
    <message>
        <source>All have the exercise’s own tooth: no template made this exercise.</source>
        <translation>Alle haben den Zahn der Übung: Sie entstand aus keiner Vorlage.</translation>
    </message>
    <message>
        <source>All have the exercise’s own tooth: its target was edited after the template made it.</source>
        <translation>Alle haben den Zahn der Übung: Ihr Ziel wurde nach der Vorlage noch bearbeitet.</translation>
    </message>
    <message>
        <source>All have the exercise’s own tooth: its template fits no other.</source>
        <translation>Alle haben den Zahn der Übung: Ihre Vorlage passt auf keinen anderen.</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Übung wählen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AssignmentsModel</name>
    <message>
        <source>any number</source>
        <translation>beliebig viele</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Fällig</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>zurückgezogen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AtWork</name>
    <message>
        <source>Leave before the work has ended?</source>
        <translation>Die Seite verlassen, bevor die Arbeit beendet ist?</translation>
    </message>
    <message>
        <source>How it ended is then shown nowhere.</source>
        <translation>Wie sie ausging, wird dann nirgends mehr angezeigt.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AttemptsModel</name>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Student/in</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Not released</source>
        <translation>Nicht freigegeben</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Audit</name>
    <message>
        <source>Neighbouring teeth</source>
        <translation>Nachbarzähne</translation>
    </message>
    <message>
        <source>The rest of the jaw</source>
        <translation>Der übrige Kiefer</translation>
    </message>
    <message>
        <source>Only near the target</source>
        <translation>Nur nahe am Ziel</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>%1 weggelassen</translation>
    </message>
    <message>
        <source>Friction left out</source>
        <translation>Reibung weggelassen</translation>
    </message>
    <message>
        <source>Handpiece left out</source>
        <translation>Handstück weggelassen</translation>
    </message>
    <message>
        <source>Vibration left out</source>
        <translation>Vibration weggelassen</translation>
    </message>
    <message>
        <source>Heat left out</source>
        <translation>Wärme weggelassen</translation>
    </message>
    <message>
        <source>Tilting of the handpiece left out</source>
        <translation>Kippen des Handstücks weggelassen</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>same score</source>
        <translation>gleiche Punkte</translation>
    </message>
    <message>
        <source>cannot be played</source>
        <translation>nicht ausführbar</translation>
    </message>
    <message>
        <source>too coarse</source>
        <translation>zu grob</translation>
    </message>
    <message>
        <source>Nothing can be left out: the exercise is as lean as its scores allow (within %1 points).</source>
        <translation>Nichts kann wegbleiben: Die Übung ist so schlank, wie es ihre Punkte zulassen (auf %1 Punkte).</translation>
    </message>
    <message>
        <source>The detail was too coarse for its scores; now half the voxels change none by more than %1 points: %2.</source>
        <translation>Die Voxel waren für die Punkte zu grob; nun ändern halb so große Voxel kein Ergebnis um mehr als %1 Punkte: %2.</translation>
    </message>
    <message>
        <source>An update takes %1 µs instead of %2, the tooth %3 MB instead of %4.</source>
        <translation>Ein Schritt braucht %1 µs statt %2, der Zahn %3 MB statt %4.</translation>
    </message>
    <message>
        <source>One thing after another was tried: a leaner set may exist.</source>
        <translation>Geprüft wurde eins nach dem anderen: Vielleicht geht es noch schlanker.</translation>
    </message>
    <message>
        <source>The audit was stopped.</source>
        <translation>Die Messung des Aufwands wurde angehalten.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The exercise cannot be played as it stands (%1).</source>
        <translation>So wie sie ist, lässt sich die Übung nicht ausführen (%1).</translation>
    </message>
    <message>
        <source>Look at its checks first.</source>
        <translation>Sehen Sie sich zuerst ihre Kontrollen an.</translation>
    </message>
    <message>
        <source>Single attempts differ by chance: over %1 attempts of each operator, half the voxels change the mean score by %2 ± %3 points.</source>
        <translation>Einzelne Versuche weichen zufällig voneinander ab: Über je %1 Versuche ändern halb so große Voxel die Punkte im Mittel um %2 ± %3.</translation>
    </message>
    <message>
        <source>Every attempt keeps its score within %1 points: %2.</source>
        <translation>Jeder Versuch behält seine Punkte auf %1 Punkte genau: %2.</translation>
    </message>
    <message>
        <source>Gums about the tooth</source>
        <translation>Gingiva um den Zahn</translation>
    </message>
    <message>
        <source>Jaw bone about the tooth</source>
        <translation>Kieferknochen um den Zahn</translation>
    </message>
    <message>
        <source>Detail of %1</source>
        <translation>Feinheit %1</translation>
    </message>
    <message>
        <source>Surface band halved</source>
        <translation>Band der Oberfläche halbiert</translation>
    </message>
    <message>
        <source>Half the voxels change which criteria can be measured.</source>
        <translation>Halb so große Voxel ändern, welche Kriterien sich messen lassen.</translation>
    </message>
    <message>
        <source>Half the voxels change whether an attempt passes, or a critical event.</source>
        <translation>Halb so große Voxel ändern, ob ein Versuch besteht, oder ein kritisches Ereignis.</translation>
    </message>
    <message>
        <source>Half the voxels change a score by %1 points, more than the %2 that the exercise allows.</source>
        <translation>Halb so große Voxel ändern ein Ergebnis um %1 Punkte, mehr als die %2, die die Übung zulässt.</translation>
    </message>
    <message>
        <source>Half the voxels may change a score by more than the %1 points that the exercise allows.</source>
        <translation>Halb so große Voxel ändern ein Ergebnis womöglich um mehr als die %1 Punkte, die die Übung zulässt.</translation>
    </message>
    <message>
        <source>No other size that was tried holds.</source>
        <translation>Keine andere geprüfte Größe genügt.</translation>
    </message>
    <message>
        <source>A scripted operator cannot reach the target (%1), so nothing can be measured.</source>
        <translation>Ein automatischer Operateur erreicht das Ziel nicht (%1); darum lässt sich nichts messen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::AuditPage</name>
    <message>
        <source>Audit</source>
        <translation>Aufwand</translation>
    </message>
    <message>
        <source>What this exercise costs</source>
        <translation>Was diese Übung kostet</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Leanest that marks the same</source>
        <translation>Das Schlankste mit gleichen Punkten</translation>
    </message>
    <message>
        <source>Use the leanest</source>
        <translation>Das Schlankste nehmen</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
    <message>
        <source>Leanest model</source>
        <translation>Schlankstes Modell</translation>
    </message>
    <message>
        <source>The exercise was changed since this was measured.</source>
        <translation>Die Übung wurde seit dieser Messung geändert.</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>%1: microseconds</source>
        <translation>%1: Mikrosekunden</translation>
    </message>
    <message>
        <source>%1: megabytes</source>
        <translation>%1: Megabyte</translation>
    </message>
    <message>
        <source>%1: change of the score</source>
        <translation>%1: Änderung der Punkte</translation>
    </message>
    <message>
        <source>As it is set</source>
        <translation>Wie eingestellt</translation>
    </message>
    <message>
        <source>for comparison</source>
        <translation>zum Vergleich</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>µs: of each update of 1 ms, more or less than now. Score: the largest change of an attempt.</source>
        <translation>µs: von jedem Schritt zu 1 ms, mehr oder weniger als jetzt. Punkte: die größte Änderung eines Versuchs.</translation>
    </message>
    <message numerus="yes">
        <source>Each choice was left out or halved once, with %n scripted attempt(s) each.</source>
        <translation>
            <numerusform>Jede Wahl blieb einmal weg oder wurde halbiert, mit je %n automatischen Versuch.</numerusform>
            <numerusform>Jede Wahl blieb einmal weg oder wurde halbiert, mit je %n automatischen Versuchen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, less than a minute left</source>
        <extracomment>%1: a share in per cent, %2: a number</extracomment>
        <translation>%1, weniger als eine Minute übrig</translation>
    </message>
    <message>
        <source>%1, about %2 min left</source>
        <translation>%1, noch etwa %2 min</translation>
    </message>
    <message>
        <source>Scripted operators drill the exercise once for each choice below, with that choice left out or halved. That takes minutes, between neighbouring teeth hours; you can go on working meanwhile.</source>
        <translation>Automatische Operateure präparieren die Übung zu jeder Wahl unten einmal, wobei diese wegbleibt oder halbiert wird. Das dauert Minuten, zwischen Nachbarzähnen Stunden; Sie können inzwischen weiterarbeiten.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BackupsTable</name>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Daily</source>
        <translation>Täglich</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>A clock was wrong, so that the dates are not in order: the newest backup stands first.</source>
        <translation>Eine Uhr ging falsch, daher stehen die Daten nicht in ihrer Reihenfolge: Die neueste Sicherung steht zuerst.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Band</name>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BandPicture</name>
    <message>
        <source>No points below</source>
        <translation>Keine Punkte unter</translation>
    </message>
    <message>
        <source>Half from</source>
        <translation>Halbe ab</translation>
    </message>
    <message>
        <source>Full from</source>
        <translation>Volle ab</translation>
    </message>
    <message>
        <source>Full to</source>
        <translation>Volle bis</translation>
    </message>
    <message>
        <source>Half to</source>
        <translation>Halbe bis</translation>
    </message>
    <message>
        <source>No points above</source>
        <translation>Keine Punkte über</translation>
    </message>
    <message>
        <source>Bands of %1 as a picture</source>
        <translation>Stufen von %1 als Bild</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BandsForm</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Your try-out</source>
        <translation>Ihr Probelauf</translation>
    </message>
    <message>
        <source>1 means yes, 0 means no.</source>
        <translation>1 bedeutet ja, 0 bedeutet nein.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BeforeAfter</name>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>The tooth before this attempt</source>
        <translation>Der Zahn vor diesem Versuch</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Briefing</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The tooth with its target</source>
        <translation>Der Zahn mit seinem Ziel</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Required depth</source>
        <translation>Solltiefe</translation>
    </message>
    <message>
        <source>%1 at the floor, %2 at the sides</source>
        <translation>%1 am Boden, %2 an den Seiten</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Enter starts</source>
        <translation>Enter startet</translation>
    </message>
    <message>
        <source>What earns points</source>
        <translation>Was Punkte bringt</translation>
    </message>
    <message>
        <source>Full points</source>
        <translation>Volle Punktzahl</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>With mouse and keys</source>
        <translation>Mit Maus und Tasten</translation>
    </message>
    <message>
        <source>Move the mouse, or the arrow keys, to slide the bur over the tooth. Push with the wheel or with Page Down, let up with Page Up. Hold Space, or the left button, to cut.</source>
        <translation>Mit der Maus oder den Pfeiltasten gleitet der Bohrer über den Zahn. Drücken Sie mit dem Mausrad oder Bild ab, geben Sie mit Bild auf nach. Zum Abtragen die Leertaste oder die linke Maustaste halten.</translation>
    </message>
    <message>
        <source>; </source>
        <extracomment>Between the burs of a list, each of which has commas of its own.</extracomment>
        <translation>; </translation>
    </message>
    <message>
        <source>Tolerance zone</source>
        <translation>Toleranzzone</translation>
    </message>
    <message>
        <source>Fails the attempt</source>
        <translation>Führt zum Nichtbestehen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>Expected time</source>
        <translation>Erwartete Zeit</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>none; time earns no points</source>
        <translation>keine; Zeit bringt keine Punkte</translation>
    </message>
    <message>
        <source>Own assessment</source>
        <translation>Selbsteinschätzung</translation>
    </message>
    <message>
        <source>asked for before the result</source>
        <translation>wird vor dem Ergebnis erfragt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a target, its depth</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Watch the ideal preparation</source>
        <translation>Idealpräparation ansehen</translation>
    </message>
    <message>
        <source>It is cut before your eyes in half a minute</source>
        <translation>Sie entsteht in einer halben Minute vor Ihren Augen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A part of the specimen</source>
        <translation>Ein Teil des Präparats</translation>
    </message>
    <message>
        <source>%1: not to be laid bare</source>
        <translation>%1: darf nicht freigelegt werden</translation>
    </message>
    <message>
        <source>%1: cut at most %2 deep</source>
        <translation>%1: darf höchstens %2 tief angeschnitten werden</translation>
    </message>
    <message>
        <source>Protected</source>
        <translation>Geschützt</translation>
    </message>
    <message>
        <source>%1: none</source>
        <comment>tolerance</comment>
        <translation>%1: keine</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BurText</name>
    <message>
        <source>entry</source>
        <translation>Eröffnung</translation>
    </message>
    <message>
        <source>undercuts</source>
        <translation>Unterschnitte</translation>
    </message>
    <message>
        <source>flat floors</source>
        <translation>ebene Böden</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>bulk removal</source>
        <translation>grober Abtrag</translation>
    </message>
    <message>
        <source>rounded line angles</source>
        <translation>gerundete Innenkanten</translation>
    </message>
    <message>
        <source>crowns</source>
        <translation>Kronen</translation>
    </message>
    <message>
        <source>inlays</source>
        <translation>Inlays</translation>
    </message>
    <message>
        <source>class I outlines</source>
        <translation>Umrisse Klasse I</translation>
    </message>
    <message>
        <source>class II outlines</source>
        <translation>Umrisse Klasse II</translation>
    </message>
    <message>
        <source>class II boxes</source>
        <translation>Kästen Klasse II</translation>
    </message>
    <message>
        <source>chamfers</source>
        <translation>Hohlkehlen</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>bevels</source>
        <translation>Abschrägungen</translation>
    </message>
    <message>
        <source>between teeth</source>
        <translation>zwischen Zähnen</translation>
    </message>
    <message>
        <source>occlusal surfaces</source>
        <translation>Kauflächen</translation>
    </message>
    <message>
        <source>lingual surfaces</source>
        <translation>linguale Flächen</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rosenbohrer</translation>
    </message>
    <message>
        <source>Inverted cone</source>
        <translation>Umgekehrter Kegel</translation>
    </message>
    <message>
        <source>Straight fissure</source>
        <translation>Fissurenbohrer, zylindrisch</translation>
    </message>
    <message>
        <source>Cross-cut fissure</source>
        <translation>Fissurenbohrer mit Querhieb</translation>
    </message>
    <message>
        <source>Dome fissure</source>
        <translation>Fissurenbohrer, rundes Ende</translation>
    </message>
    <message>
        <source>Tapered fissure</source>
        <translation>Fissurenbohrer, konisch</translation>
    </message>
    <message>
        <source>Cross-cut tapered fissure</source>
        <translation>Fissurenbohrer, konisch mit Querhieb</translation>
    </message>
    <message>
        <source>Pear</source>
        <translation>Birne</translation>
    </message>
    <message>
        <source>Long pear</source>
        <translation>Lange Birne</translation>
    </message>
    <message>
        <source>Round-end taper</source>
        <translation>Kegel, rundes Ende</translation>
    </message>
    <message>
        <source>Flat-end taper</source>
        <translation>Kegel, flaches Ende</translation>
    </message>
    <message>
        <source>Flame</source>
        <translation>Flamme</translation>
    </message>
    <message>
        <source>Football</source>
        <translation>Ei</translation>
    </message>
    <message>
        <source>Own shape</source>
        <translation>Eigene Form</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>inverted cone</source>
        <translation>umgekehrter Kegel</translation>
    </message>
    <message>
        <source>straight fissure</source>
        <translation>Fissur zylindrisch</translation>
    </message>
    <message>
        <source>cross-cut fissure</source>
        <translation>Fissur mit Querhieb</translation>
    </message>
    <message>
        <source>dome fissure</source>
        <translation>Fissur rund</translation>
    </message>
    <message>
        <source>tapered fissure</source>
        <translation>Fissur konisch</translation>
    </message>
    <message>
        <source>cross-cut tapered fissure</source>
        <translation>Fissur konisch mit Querhieb</translation>
    </message>
    <message>
        <source>pear</source>
        <translation>Birne</translation>
    </message>
    <message>
        <source>long pear</source>
        <translation>lange Birne</translation>
    </message>
    <message>
        <source>round-end taper</source>
        <translation>Kegel rund</translation>
    </message>
    <message>
        <source>flat-end taper</source>
        <translation>Kegel flach</translation>
    </message>
    <message>
        <source>flame</source>
        <translation>Flamme</translation>
    </message>
    <message>
        <source>football</source>
        <translation>Ei</translation>
    </message>
    <message>
        <source>own shape</source>
        <translation>eigene Form</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>Number of a bur, its shape, its diameter.</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>carious lesion</source>
        <translation>kariöse Läsion</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BurTray</name>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ und ]</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>Kind of bur and its diameter in mm, as &quot;round 1.0&quot;.</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Bur %1</source>
        <translation>Bohrer %1</translation>
    </message>
    <message>
        <source>Lift the bur out to change it.</source>
        <translation>Zum Wechseln den Bohrer aus dem Zahn heben.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::BursForm</name>
    <message>
        <source>Bur to add</source>
        <translation>Neuer Bohrer</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a bur</source>
        <translation>Bohrer hinzufügen</translation>
    </message>
    <message>
        <source>Bur %1</source>
        <translation>Bohrer %1</translation>
    </message>
    <message>
        <source>Diameter of bur %1</source>
        <translation>Durchmesser von Bohrer %1</translation>
    </message>
    <message>
        <source>Remove bur %1</source>
        <translation>Bohrer %1 entfernen</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Number, shape and diameter</source>
        <translation>Nummer, Form und Durchmesser</translation>
    </message>
    <message>
        <source>Add from the catalogue</source>
        <translation>Aus dem Katalog hinzufügen</translation>
    </message>
    <message>
        <source>Shape of the bur to add</source>
        <translation>Form des Bohrers, der hinzukommt</translation>
    </message>
    <message>
        <source>Sizes and outlines are the usual ones, not verified. Blades are not modelled: a head is the body that they sweep.</source>
        <translation>Größen und Umrisse sind die üblichen, nicht geprüft. Schneiden sind nicht nachgebildet: Ein Kopf ist der Körper, den sie überstreichen.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>Number of a bur and its diameter.</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>All burs of this shape are in the exercise.</source>
        <translation>Alle Bohrer dieser Form sind in der Übung.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Busy</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CandidatesModel</name>
    <message>
        <source>to be confirmed</source>
        <translation>zu bestätigen</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>by the program</source>
        <translation>vom Programm</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Candidate</source>
        <translation>Kandidat/in</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>Begonnen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Bewertet</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>%1 % more time</source>
        <translation>%1 % mehr Zeit</translation>
    </message>
    <message>
        <source>large text</source>
        <translation>große Schrift</translation>
    </message>
    <message>
        <source>Adjustments</source>
        <translation>Nachteilsausgleich</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>konnte nicht gelesen werden</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Changes</name>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Measured from height</source>
        <translation>Gemessen ab Höhe</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Length and width of the box</source>
        <translation>Länge und Breite des Kastens</translation>
    </message>
    <message>
        <source>Lean of a wall</source>
        <translation>Neigung einer Wand</translation>
    </message>
    <message>
        <source>Points of the outline</source>
        <translation>Punkte des Umrisses</translation>
    </message>
    <message>
        <source>Shape of the target</source>
        <translation>Form des Ziels</translation>
    </message>
    <message>
        <source>Tolerance zone, floor</source>
        <translation>Toleranzzone, Boden</translation>
    </message>
    <message>
        <source>Tolerance zone, sides</source>
        <translation>Toleranzzone, Seiten</translation>
    </message>
    <message>
        <source>Tolerance zone of single faces</source>
        <translation>Toleranzzone einzelner Flächen</translation>
    </message>
    <message>
        <source>Pass mark, of 100</source>
        <translation>Bestehensgrenze, von 100</translation>
    </message>
    <message>
        <source>Points for %1</source>
        <translation>Punkte für %1</translation>
    </message>
    <message>
        <source>Bands of %1</source>
        <translation>Stufen von %1</translation>
    </message>
    <message>
        <source>Criterion %1</source>
        <translation>Kriterium %1</translation>
    </message>
    <message>
        <source>Order of the criteria</source>
        <translation>Reihenfolge der Kriterien</translation>
    </message>
    <message>
        <source>“%1” fails the attempt</source>
        <translation>„%1“ lässt den Versuch scheitern</translation>
    </message>
    <message>
        <source>Radius of bur %1</source>
        <translation>Radius von Bohrer %1</translation>
    </message>
    <message>
        <source>Shape of bur %1</source>
        <translation>Form von Bohrer %1</translation>
    </message>
    <message>
        <source>Bur %1</source>
        <translation>Bohrer %1</translation>
    </message>
    <message>
        <source>Order of the burs</source>
        <translation>Reihenfolge der Bohrer</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Steifigkeit: %1</translation>
    </message>
    <message>
        <source>Removal speed of %1</source>
        <translation>Abtragsgeschwindigkeit: %1</translation>
    </message>
    <message>
        <source>Tissue %1</source>
        <translation>Gewebe %1</translation>
    </message>
    <message>
        <source>Order of the tissues</source>
        <translation>Reihenfolge der Gewebe</translation>
    </message>
    <message>
        <source>What is protected</source>
        <translation>Was geschützt ist</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Natural variation of the tooth</source>
        <translation>Natürliche Variation des Zahns</translation>
    </message>
    <message>
        <source>Carious lesions</source>
        <translation>Kariöse Läsionen</translation>
    </message>
    <message>
        <source>What stands about the tooth</source>
        <translation>Was um den Zahn steht</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Expected time</source>
        <translation>Erwartete Zeit</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>Titel, %1</translation>
    </message>
    <message>
        <source>Briefing, %1</source>
        <translation>Aufgabe, %1</translation>
    </message>
    <message>
        <source>How forces are computed</source>
        <translation>Wie die Kräfte berechnet werden</translation>
    </message>
    <message>
        <source>Handpiece, vibration, sound, water and heat</source>
        <translation>Handstück, Vibration, Ton, Wasser und Wärme</translation>
    </message>
    <message>
        <source>Change of the score that an audit accepts</source>
        <translation>Änderung der Punkte, die eine Messung des Aufwands hinnimmt</translation>
    </message>
    <message>
        <source>What the device has to do</source>
        <translation>Was das Gerät können muss</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: %2, was %3</source>
        <extracomment>%1: what changed (&quot;Depth&quot;), %2: its value now, %3: its value before</extracomment>
        <translation>%1: %2, vorher %3</translation>
    </message>
    <message>
        <source>Full points for %1</source>
        <translation>Volle Punkte für %1</translation>
    </message>
    <message>
        <source>%1: changed</source>
        <extracomment>%1: what changed (&quot;Points of the outline&quot;)</extracomment>
        <translation>%1: geändert</translation>
    </message>
    <message>
        <source>%1: new</source>
        <translation>%1: neu</translation>
    </message>
    <message>
        <source>%1: removed</source>
        <translation>%1: entfernt</translation>
    </message>
    <message>
        <source>Own assessment before the result</source>
        <translation>Selbsteinschätzung vor dem Ergebnis</translation>
    </message>
    <message>
        <source>Landmarks of the tooth</source>
        <translation>Landmarken des Zahns</translation>
    </message>
    <message>
        <source>Template and its values</source>
        <translation>Vorlage und ihre Werte</translation>
    </message>
    <message>
        <source>Tilt of the handpiece</source>
        <translation>Neigung des Handstücks</translation>
    </message>
    <message>
        <source>Turn of the handpiece</source>
        <translation>Drehung des Handstücks</translation>
    </message>
    <message>
        <source>The force at which cutting is fastest</source>
        <translation>Die Kraft, bei der am schnellsten abgetragen wird</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Chart</name>
    <message>
        <source>Which</source>
        <translation>Bezeichnung</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Checks</name>
    <message>
        <source>An attempt that cuts a twentieth of the target gets %1 points. Give full points for the target only where most of it is removed.</source>
        <translation>Ein Versuch, der ein Zwanzigstel des Ziels abträgt, erhält %1 Punkte. Volle Punkte für das Ziel nur dort geben, wo das meiste abgetragen ist.</translation>
    </message>
    <message>
        <source>The target is made of %1, which this tooth does not have.</source>
        <translation>Das Ziel besteht aus einem Gewebe, das dieser Zahn nicht hat: %1.</translation>
    </message>
    <message>
        <source>The target follows a carious lesion, and this tooth has none.</source>
        <translation>Das Ziel folgt einer kariösen Läsion, und dieser Zahn hat keine.</translation>
    </message>
    <message>
        <source>There is no bur to work with. Add one.</source>
        <translation>Es gibt keinen Bohrer zum Arbeiten. Fügen Sie einen hinzu.</translation>
    </message>
    <message>
        <source>There is no target to cut.</source>
        <translation>Es gibt kein Ziel zum Abtragen.</translation>
    </message>
    <message>
        <source>The target’s points do not fit its shape.</source>
        <translation>Die Punkte des Ziels passen nicht zu seiner Form.</translation>
    </message>
    <message>
        <source>Nothing is graded yet. Add a criterion.</source>
        <translation>Noch wird nichts bewertet. Fügen Sie ein Kriterium hinzu.</translation>
    </message>
    <message>
        <source>%1 has no points. Give it some, or remove it.</source>
        <translation>%1 hat keine Punkte. Geben Sie ihm welche oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>The bands of %1 are not in rising order.</source>
        <translation>Die Stufen von %1 steigen nicht an.</translation>
    </message>
    <message>
        <source>The pass mark %1 is out of reach: at most %2 points can be had.</source>
        <translation>Die Bestehensgrenze %1 ist nicht erreichbar: höchstens %2 Punkte sind möglich.</translation>
    </message>
    <message>
        <source>%1 is protected, but this tooth has none.</source>
        <translation>%1 ist geschützt, kommt an diesem Zahn aber nicht vor.</translation>
    </message>
    <message>
        <source>The tooth holds %1, which this exercise does not describe.</source>
        <translation>Der Zahn enthält %1; diese Übung beschreibt das nicht.</translation>
    </message>
    <message>
        <source>%1 is described, but this tooth has none.</source>
        <translation>%1 ist beschrieben, kommt an diesem Zahn aber nicht vor.</translation>
    </message>
    <message>
        <source>The target reaches out of the tooth: to %1, where the tooth ends at %2.</source>
        <translation>Das Ziel ragt aus dem Zahn: bis %1, der Zahn endet bei %2.</translation>
    </message>
    <message>
        <source>The file’s fineness is %2, not %1 as stated.</source>
        <translation>Die Feinheit der Datei ist %2, nicht %1 wie angegeben.</translation>
    </message>
    <message>
        <source>%1 is too thin to be judged at this fineness; from %2 it can.</source>
        <translation>%1 ist bei dieser Feinheit zu dünn zum Beurteilen; ab %2 geht es.</translation>
    </message>
    <message>
        <source>No bur fits: the smallest is %1 wide, the target %2.</source>
        <translation>Kein Bohrer passt: der kleinste ist %1 breit, das Ziel %2.</translation>
    </message>
    <message>
        <source>The corner radius %1 is sharper than the smallest bur leaves it (%2).</source>
        <translation>Der Eckenradius %1 ist schärfer, als ihn der kleinste Bohrer hinterlässt (%2).</translation>
    </message>
    <message>
        <source>A point of the target does not lie on its floor.</source>
        <translation>Ein Punkt des Ziels liegt nicht auf seinem Boden.</translation>
    </message>
    <message>
        <source>The title is missing in %1.</source>
        <translation>Der Titel fehlt auf %1.</translation>
    </message>
    <message>
        <source>The briefing is missing in %1.</source>
        <translation>Die Aufgabe fehlt auf %1.</translation>
    </message>
    <message>
        <source>Nothing of this tooth can be cut.</source>
        <translation>Von diesem Zahn lässt sich nichts abtragen.</translation>
    </message>
    <message>
        <source>Something is wrong at %1.</source>
        <translation>Bei %1 stimmt etwas nicht.</translation>
    </message>
    <message>
        <source>Only one handpiece can be used at a time.</source>
        <translation>Es kann nur ein Handstück zugleich benutzt werden.</translation>
    </message>
    <message>
        <source>The drilling sound needs a handpiece.</source>
        <translation>Das Bohrgeräusch braucht ein Handstück.</translation>
    </message>
    <message>
        <source>Vibration needs a handpiece.</source>
        <translation>Vibration braucht ein Handstück.</translation>
    </message>
    <message>
        <source>%1 is graded, but this exercise does not reckon coolant and heat.</source>
        <translation>%1 wird bewertet, aber diese Übung berechnet Kühlung und Wärme nicht.</translation>
    </message>
    <message>
        <source>Bur %1 is too small for this fineness: its diameter is %2, from %3 it cuts truly.</source>
        <translation>Bohrer %1 ist für diese Feinheit zu klein: sein Durchmesser ist %2, ab %3 trägt er genau ab.</translation>
    </message>
    <message>
        <source>The head of bur %1 is too short for this fineness: %2 long, from %3 it cuts truly.</source>
        <translation>Der Kopf von Bohrer %1 ist für diese Feinheit zu kurz: %2 lang, ab %3 trägt er genau ab.</translation>
    </message>
    <message>
        <source>The neck of bur %1 is wider than its head.</source>
        <translation>Der Hals von Bohrer %1 ist dicker als sein Kopf.</translation>
    </message>
    <message>
        <source>The stiffness of a tissue</source>
        <translation>Die Steifigkeit eines Gewebes</translation>
    </message>
    <message>
        <source>The removal speed of a tissue</source>
        <translation>Die Abtragsgeschwindigkeit eines Gewebes</translation>
    </message>
    <message>
        <source>A measure of a bur</source>
        <translation>Ein Maß eines Bohrers</translation>
    </message>
    <message>
        <source>The target’s width</source>
        <translation>Die Breite des Ziels</translation>
    </message>
    <message>
        <source>The target’s depth</source>
        <translation>Die Tiefe des Ziels</translation>
    </message>
    <message>
        <source>The corner radius</source>
        <translation>Der Eckenradius</translation>
    </message>
    <message>
        <source>The tolerance zone</source>
        <translation>Die Toleranzzone</translation>
    </message>
    <message>
        <source>The time limit</source>
        <translation>Die Zeitgrenze</translation>
    </message>
    <message>
        <source>The pass mark</source>
        <translation>Die Bestehensgrenze</translation>
    </message>
    <message>
        <source>The points of a criterion</source>
        <translation>Die Punkte eines Kriteriums</translation>
    </message>
    <message>
        <source>The fineness</source>
        <translation>Die Feinheit</translation>
    </message>
    <message>
        <source>%1 is %2; it has to lie between %3 and %4.</source>
        <translation>%1: %2; erlaubt ist %3 bis %4.</translation>
    </message>
    <message>
        <source>The target holds %1 of pulp, as the access to a root canal does. If that is not meant, raise its floor.</source>
        <translation>Das Ziel enthält %1 Pulpa, wie die Zugangskavität zu einem Wurzelkanal. Ist das nicht gemeint, heben Sie seinen Boden an.</translation>
    </message>
    <message>
        <source>Opening the pulp does not fail the attempt. Switch that on unless it is meant so.</source>
        <translation>Eine eröffnete Pulpa lässt den Versuch nicht scheitern. Schalten Sie das ein, wenn es nicht so gemeint ist.</translation>
    </message>
    <message>
        <source>The target takes %1, which is protected.</source>
        <translation>Das Ziel trägt Geschütztes ab: %1.</translation>
    </message>
    <message>
        <source>The tolerance zone reaches %1, which is protected.</source>
        <translation>Die Toleranzzone erreicht Geschütztes: %1.</translation>
    </message>
    <message>
        <source>The target holds nothing that could be cut.</source>
        <translation>Das Ziel enthält nichts, was abgetragen werden könnte.</translation>
    </message>
    <message>
        <source>An attempt that cuts nothing gets %1 points. Grade how much of the target is removed.</source>
        <translation>Ein Versuch, der nichts abträgt, bekommt %1 Punkte. Bewerten Sie, wie viel des Ziels abgetragen ist.</translation>
    </message>
    <message>
        <source>An attempt that cuts a twentieth of the target passes, with %1 points. Grade how much of the target is removed.</source>
        <translation>Ein Versuch, der ein Zwanzigstel des Ziels abträgt, besteht mit %1 Punkten. Bewerten Sie, wie viel des Ziels abgetragen ist.</translation>
    </message>
    <message>
        <source>%1 brings less than a twentieth of a point. Give it more, or remove it.</source>
        <translation>%1 bringt weniger als ein Zwanzigstel eines Punkts. Geben Sie mehr, oder entfernen Sie das Kriterium.</translation>
    </message>
    <message>
        <source>The title in %1 is still that of the exercise it was copied from.</source>
        <translation>Der Titel in der Sprache %1 ist noch der der Übung, von der er kopiert wurde.</translation>
    </message>
    <message>
        <source>The briefing in %1 is still that of the exercise it was copied from.</source>
        <translation>Die Aufgabe in der Sprache %1 ist noch die der Übung, von der sie kopiert wurde.</translation>
    </message>
    <message>
        <source>The title in %1 names tooth %2; the exercise is on tooth %3.</source>
        <translation>Der Titel in der Sprache %1 nennt Zahn %2; die Übung findet an Zahn %3 statt.</translation>
    </message>
    <message>
        <source>The briefing in %1 names %2, which the target no longer has.</source>
        <translation>Die Aufgabe in der Sprache %1 nennt %2; dieses Maß hat das Ziel nicht mehr.</translation>
    </message>
    <message>
        <source>The target opens the pulp by %1. Raise its floor, or draw it clear of the pulp.</source>
        <translation>Das Ziel eröffnet die Pulpa um %1. Heben Sie seinen Boden an, oder zeichnen Sie es an der Pulpa vorbei.</translation>
    </message>
    <message>
        <source>The tolerance zone of %1 is finer than the tooth is known (%2).</source>
        <translation>Die Toleranzzone von %1 ist feiner, als der Zahn bekannt ist (%2).</translation>
    </message>
    <message>
        <source>An attempt that meets the target exactly loses %1 points for %2.</source>
        <translation>Ein Versuch, der das Ziel genau trifft, verliert %1 Punkte für %2.</translation>
    </message>
    <message>
        <source>The target reaches into the pulp, and opening it fails the attempt: nobody could pass.</source>
        <translation>Das Ziel reicht in die Pulpa, und sie zu eröffnen heißt nicht bestehen: Niemand könnte bestehen.</translation>
    </message>
    <message>
        <source>The tolerance zone reaches the pulp: it lies %1 from the target.</source>
        <translation>Die Toleranzzone reicht bis in die Pulpa: Diese liegt %1 vom Ziel entfernt.</translation>
    </message>
    <message>
        <source>A shape of the target has no direction: an axis has no length, or two are parallel.</source>
        <translation>Eine Form des Ziels hat keine Richtung: Eine Achse hat keine Länge, oder zwei sind parallel.</translation>
    </message>
    <message>
        <source>The target has no end on a side. Cut it with a shape that has one.</source>
        <translation>Das Ziel hat auf einer Seite kein Ende. Schneiden Sie es mit einer Form, die eines hat.</translation>
    </message>
    <message>
        <source>Damage of a protected part fails the attempt, and nothing is protected.</source>
        <translation>Verletzung von Geschütztem lässt den Versuch scheitern, und nichts ist geschützt.</translation>
    </message>
    <message>
        <source>The expected time</source>
        <translation>Die erwartete Zeit</translation>
    </message>
    <message>
        <source>The expected time, %1, is longer than the time limit, %2.</source>
        <translation>Die erwartete Zeit, %1, ist länger als die Zeitgrenze, %2.</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>The tooth lies %1 degrees off its frame. Beyond %2 nobody knows its mesial side: turn the file.</source>
        <translation>Der Zahn liegt um %1 Grad verdreht. Über %2 ist seine mesiale Seite nicht bekannt: die Datei drehen.</translation>
    </message>
    <message>
        <source>The tooth’s long axis leans by %1 degrees, at most %2 are usual: turn the file.</source>
        <translation>Die Längsachse des Zahns neigt sich um %1 Grad, üblich sind höchstens %2: die Datei drehen.</translation>
    </message>
    <message>
        <source>A landmark does not lie on the tooth. It may be another file’s.</source>
        <translation>Eine Landmarke liegt nicht auf dem Zahn. Vielleicht gehört sie zu einer anderen Datei.</translation>
    </message>
    <message>
        <source>%1 is of a target that this exercise does not have. Remove it.</source>
        <translation>%1 gehört zu einem Ziel, das diese Übung nicht hat. Entfernen Sie es.</translation>
    </message>
    <message>
        <source>The name of a target is missing in %1.</source>
        <translation>Der Name eines Ziels fehlt auf %1.</translation>
    </message>
    <message>
        <source>The target holds %1, which cannot be cut.</source>
        <translation>Das Ziel enthält %1; das lässt sich nicht abtragen.</translation>
    </message>
    <message>
        <source>The lean of a wall</source>
        <translation>Die Neigung einer Wand</translation>
    </message>
    <message>
        <source>a region</source>
        <translation>einen Bereich</translation>
    </message>
    <message>
        <source>%1 cannot be measured on this tooth with this target, so nobody would be graded by it. Remove it, or change tooth or target.</source>
        <translation>%1 lässt sich an diesem Zahn mit diesem Ziel nicht messen; niemand würde danach bewertet. Entfernen Sie es, oder ändern Sie Zahn oder Ziel.</translation>
    </message>
    <message>
        <source>%1 stands twice among what fails the attempt. Switch it off and on again.</source>
        <translation>%1 steht zweimal bei dem, was den Versuch scheitern lässt. Schalten Sie es aus und wieder ein.</translation>
    </message>
    <message>
        <source>The tilt of the handpiece</source>
        <translation>Die Neigung des Handstücks</translation>
    </message>
    <message>
        <source>The turn of the handpiece</source>
        <translation>Die Drehung des Handstücks</translation>
    </message>
    <message>
        <source>The force at which cutting is fastest</source>
        <translation>Die Kraft, bei der am schnellsten abgetragen wird</translation>
    </message>
    <message>
        <source>%1 is protected twice: what is removed of it counts twice. Take one of the two out of the file.</source>
        <translation>%1 ist zweimal geschützt: Was davon abgetragen wird, zählt doppelt. Nehmen Sie eines der beiden aus der Datei.</translation>
    </message>
    <message>
        <source>A mesial or distal wall of the target stands on the other side of this tooth. Draw the target anew, or choose the tooth’s right number.</source>
        <translation>Eine mesiale oder distale Wand des Ziels steht auf der anderen Seite dieses Zahns. Zeichnen Sie das Ziel neu, oder wählen Sie die richtige Nummer des Zahns.</translation>
    </message>
    <message>
        <source>The target names mesial and distal walls, and the file does not state where mesial lies. Choose the tooth’s number and propose landmarks.</source>
        <translation>Das Ziel benennt mesiale und distale Wände, und die Datei gibt nicht an, wo mesial liegt. Wählen Sie die Nummer des Zahns und lassen Sie Landmarken vorschlagen.</translation>
    </message>
    <message>
        <source>The catalogue’s bur %1 has another shape or diameter (%2). Add it from the catalogue again, or change its diameter.</source>
        <translation>Der Bohrer %1 des Katalogs hat eine andere Form oder einen anderen Durchmesser (%2). Fügen Sie ihn neu aus dem Katalog hinzu, oder ändern Sie seinen Durchmesser.</translation>
    </message>
    <message>
        <source>No bur reaches the floor: the longest cuts %1 deep before its shank touches, and the target is %2 deep.</source>
        <translation>Kein Bohrer erreicht den Boden: Der längste schleift %1 tief, bevor sein Schaft anstößt, und das Ziel ist %2 tief.</translation>
    </message>
    <message>
        <source>%1 cannot be measured where tooth and neighbours are of plastic: both are one material. Remove it, or the neighbours.</source>
        <translation>%1 lässt sich nicht messen, wo Zahn und Nachbarn aus Kunststoff sind: Beide sind ein Material. Entfernen Sie das Kriterium oder die Nachbarn.</translation>
    </message>
    <message>
        <source>An attempt that cuts the target and nothing else fails: %1.</source>
        <translation>Ein Versuch, der das Ziel und sonst nichts abträgt, ist nicht bestanden: %1.</translation>
    </message>
    <message>
        <source>An attempt that cuts the target and nothing else gets %1 points, and the pass mark is %2. Fit the bands to the target.</source>
        <translation>Ein Versuch, der das Ziel und sonst nichts abträgt, bekommt %1 Punkte, und die Bestehensgrenze ist %2. Passen Sie die Stufen an das Ziel an.</translation>
    </message>
    <message>
        <source>%1 earns its points whatever is measured. Set what earns them, or remove it.</source>
        <translation>%1 bringt seine Punkte, was auch gemessen wird. Legen Sie fest, wofür es sie gibt, oder entfernen Sie es.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Cli</name>
    <message>
        <source>This database has no account “demo”: --as names the account to act as.</source>
        <translation>Diese Datenbank hat kein Konto „demo“: --as nennt das Konto, das handelt.</translation>
    </message>
    <message>
        <source>Password: </source>
        <translation>Passwort: </translation>
    </message>
    <message>
        <source>%1 is not a session’s id.</source>
        <translation>%1 ist keine Kennung eines Versuchs.</translation>
    </message>
    <message>
        <source>%1 of %2 points: %3</source>
        <translation>%1 von %2 Punkten: %3</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Datenbank</translation>
    </message>
    <message>
        <source>The session&apos;s id</source>
        <translation>Kennung des Versuchs</translation>
    </message>
    <message>
        <source>Another rubric: a scenario.json or its rubric alone. Shown, not stored</source>
        <translation>Anderer Bewertungsschlüssel: eine scenario.json oder nur deren Schlüssel. Wird gezeigt, nicht gespeichert</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) and the audit log are whole.</source>
        <translation>
            <numerusform>%n Versuch und das Protokoll sind unversehrt.</numerusform>
            <numerusform>%n Versuche und das Protokoll sind unversehrt.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is kept: sessions, one of them, or proof of all</source>
        <translation>Was aufbewahrt ist: Versuche, einer davon oder der Nachweis für alle</translation>
    </message>
    <message>
        <source>Sessions, newest first</source>
        <translation>Versuche, neueste zuerst</translation>
    </message>
    <message>
        <source>Part of a name or number</source>
        <translation>Teil eines Namens oder einer Nummer</translation>
    </message>
    <message>
        <source>At most so many</source>
        <translation>Höchstens so viele</translation>
    </message>
    <message>
        <source>One session: events, removed tissue, grade</source>
        <translation>Ein Versuch: Ereignisse, abgetragenes Gewebe, Bewertung</translation>
    </message>
    <message>
        <source>The file, each session&apos;s chain, and the audit log</source>
        <translation>Die Datei, die Kette jedes Versuchs und das Protokoll</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>-o VOLUME is missing: the file to write.</source>
        <translation>-o VOLUME fehlt: die Datei, die geschrieben wird.</translation>
    </message>
    <message>
        <source>%1 is no axis: x, y, z, -x, -y or -z.</source>
        <translation>%1 ist keine Achse: x, y, z, -x, -y oder -z.</translation>
    </message>
    <message>
        <source>%1 is not MESH=TISSUE with a tissue such as enamel, dentine or pulp.</source>
        <translation>%1 ist nicht MESH=TISSUE mit einem Gewebe wie enamel, dentine oder pulp.</translation>
    </message>
    <message>
        <source>--tissue MESH=TISSUE gives the tissue of each mesh; --list names the meshes.</source>
        <translation>--tissue MESH=TISSUE gibt das Gewebe jedes Netzes an; --list nennt die Netze.</translation>
    </message>
    <message>
        <source>Volume to write (NRRD)</source>
        <translation>Zu schreibendes Volumen (NRRD)</translation>
    </message>
    <message>
        <source>Length of one unit of the file in millimetres</source>
        <translation>Länge einer Einheit der Datei in Millimetern</translation>
    </message>
    <message>
        <source>Edge of a voxel in millimetres</source>
        <translation>Kantenlänge eines Voxels in Millimetern</translation>
    </message>
    <message>
        <source>The file&apos;s axis towards the chewing surface</source>
        <translation>Achse der Datei, die zur Kaufläche zeigt</translation>
    </message>
    <message>
        <source>expert, competent, novice, too_deep, too_shallow, shaky, off_outline, pulp, dry, or a CSV file of inputs</source>
        <translation>expert, competent, novice, too_deep, too_shallow, shaky, off_outline, pulp, dry oder eine CSV-Datei mit Eingaben</translation>
    </message>
    <message>
        <source>Of the scripted operator&apos;s tremor</source>
        <translation>Des Zitterns des automatischen Operateurs</translation>
    </message>
    <message>
        <source>Print each second of the session to stderr as it is played</source>
        <translation>Jede Sekunde des Versuchs auf stderr ausgeben, während er läuft</translation>
    </message>
    <message>
        <source>Database; made when it is not there. Without it: cusp.db in DIR</source>
        <translation>Datenbank; wird angelegt, wenn sie fehlt. Ohne Angabe: cusp.db in DIR</translation>
    </message>
    <message>
        <source>The record is whole. It was made by engine %1 and is not computed again by engine %2.</source>
        <translation>Die Aufzeichnung ist unversehrt. Sie stammt von Rechenkern %1 und wird von Rechenkern %2 nicht neu berechnet.</translation>
    </message>
    <message numerus="yes">
        <source>The record is whole; %n tick(s) come to the same tooth and grade, bit for bit.</source>
        <translation>
            <numerusform>Die Aufzeichnung ist unversehrt; %n Takt ergibt denselben Zahn und dieselbe Bewertung, Bit für Bit.</numerusform>
            <numerusform>Die Aufzeichnung ist unversehrt; %n Takte ergeben denselben Zahn und dieselbe Bewertung, Bit für Bit.</numerusform>
        </translation>
    </message>
    <message>
        <source>Run a stored session again and print the hash of its tooth</source>
        <translation>Einen gespeicherten Versuch erneut rechnen und die Prüfsumme seines Zahns ausgeben</translation>
    </message>
    <message>
        <source>Prove it: the record&apos;s chain, then tooth and grade bit for bit</source>
        <translation>Nachweisen: die Kette der Aufzeichnung, dann Zahn und Bewertung Bit für Bit</translation>
    </message>
    <message>
        <source>The record and the report are kept.</source>
        <translation>Aufzeichnung und Bericht sind aufbewahrt.</translation>
    </message>
    <message>
        <source>Grow a specimen and write its volume</source>
        <translation>Ein Präparat erzeugen und sein Volumen schreiben</translation>
    </message>
    <message>
        <source>tooth, block, layered-block or paper-block</source>
        <translation>tooth, block, layered-block oder paper-block</translation>
    </message>
    <message>
        <source>A tooth of plastic, as in a training model</source>
        <translation>Ein Zahn aus Kunststoff, wie in einem Übungsmodell</translation>
    </message>
    <message>
        <source>With the teeth that touch it</source>
        <translation>Mit den Zähnen, die ihn berühren</translation>
    </message>
    <message>
        <source>With the gingiva about it</source>
        <translation>Mit der Gingiva ringsum</translation>
    </message>
    <message>
        <source>With the bone and the ligament about its roots</source>
        <translation>Mit Knochen und Desmodont um seine Wurzeln</translation>
    </message>
    <message>
        <source>Tooth number, 11 to 48</source>
        <translation>Zahnnummer, 11 bis 48</translation>
    </message>
    <message>
        <source>Natural variation; 0 = the average tooth</source>
        <translation>Natürliche Variation; 0 = der Durchschnittszahn</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fehler: %1</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation>%1 ist nicht verwendbar: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 cannot be used: %2 (and %n more)</source>
        <translation>
            <numerusform>%1 ist nicht verwendbar: %2 (und %n weiterer Grund)</numerusform>
            <numerusform>%1 ist nicht verwendbar: %2 (und %n weitere Gründe)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 can be used.</source>
        <translation>%1 ist verwendbar.</translation>
    </message>
    <message>
        <source>Check a scenario: its form, its values, and its specimen</source>
        <translation>Eine Übung prüfen: Form, Werte und Präparat</translation>
    </message>
    <message>
        <source>A scenario.json, its folder, or a built-in one</source>
        <translation>Eine scenario.json, ihr Ordner oder eine mitgelieferte</translation>
    </message>
    <message>
        <source>Leave the specimen out</source>
        <translation>Das Präparat auslassen</translation>
    </message>
    <message>
        <source>Write the result as JSON to FILE, or to stdout for -</source>
        <translation>Das Ergebnis als JSON in FILE schreiben, bei - auf stdout</translation>
    </message>
    <message>
        <source>Cusp: cavity preparation with a grade. Without a verb, cusp [--db FILE] [--safe] [NAME.cusp] opens the desktop.</source>
        <translation>Cusp: Kavitätenpräparation mit Bewertung. Ohne Befehl öffnet cusp [--db DATEI] [--safe] [NAME.cusp] die Oberfläche.</translation>
    </message>
    <message>
        <source>%1 (see cusp VERB --help)</source>
        <translation>%1 (siehe cusp BEFEHL --help)</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Der Speicher reicht nicht.</translation>
    </message>
    <message>
        <source>Something unexpected happened (%1). What was recorded before is kept.</source>
        <translation>Etwas Unerwartetes ist geschehen (%1). Was vorher aufgezeichnet war, ist aufbewahrt.</translation>
    </message>
    <message>
        <source>it has no instrument</source>
        <translation>es gibt kein Instrument</translation>
    </message>
    <message>
        <source>it has no target</source>
        <translation>es gibt kein Ziel</translation>
    </message>
    <message>
        <source>the target’s path does not fit its shape</source>
        <translation>der Pfad des Ziels passt nicht zu seiner Form</translation>
    </message>
    <message>
        <source>the target is empty</source>
        <translation>das Ziel ist leer</translation>
    </message>
    <message>
        <source>the rubric has no criterion</source>
        <translation>der Bewertungsschlüssel hat kein Kriterium</translation>
    </message>
    <message>
        <source>no criterion brings points</source>
        <translation>kein Kriterium bringt Punkte</translation>
    </message>
    <message>
        <source>the bands are not in rising order</source>
        <translation>die Stufen steigen nicht an</translation>
    </message>
    <message>
        <source>the pass mark cannot be reached</source>
        <translation>die Bestehensgrenze ist nicht erreichbar</translation>
    </message>
    <message>
        <source>a protected tissue is missing (%1)</source>
        <translation>ein geschütztes Gewebe fehlt (%1)</translation>
    </message>
    <message>
        <source>the specimen holds a tissue that is not described (%1)</source>
        <translation>das Präparat enthält ein Gewebe, das nicht beschrieben ist (%1)</translation>
    </message>
    <message>
        <source>a tissue does not occur in the specimen (%1)</source>
        <translation>ein Gewebe kommt im Präparat nicht vor (%1)</translation>
    </message>
    <message>
        <source>the target lies outside the specimen</source>
        <translation>das Ziel liegt außerhalb des Präparats</translation>
    </message>
    <message>
        <source>the volume’s voxels are not of the size that is stated</source>
        <translation>die Voxel des Volumens haben nicht die angegebene Größe</translation>
    </message>
    <message>
        <source>a feature is thinner than 2.5 voxels and cannot be judged</source>
        <translation>eine Einzelheit ist dünner als 2,5 Voxel und nicht beurteilbar</translation>
    </message>
    <message>
        <source>a bur’s radius is below 3 voxels</source>
        <translation>der Radius eines Bohrers liegt unter 3 Voxeln</translation>
    </message>
    <message>
        <source>a bur’s neck is wider than its ball</source>
        <translation>der Hals eines Bohrers ist breiter als seine Kugel</translation>
    </message>
    <message>
        <source>no bur fits into the target</source>
        <translation>kein Bohrer passt in das Ziel</translation>
    </message>
    <message>
        <source>the target’s corners are sharper than the smallest bur</source>
        <translation>die Ecken des Ziels sind schärfer als der kleinste Bohrer</translation>
    </message>
    <message>
        <source>points of the path do not lie on the floor</source>
        <translation>Punkte des Pfads liegen nicht auf dem Boden</translation>
    </message>
    <message>
        <source>a text is missing in a language (%1)</source>
        <translation>ein Text fehlt in einer Sprache (%1)</translation>
    </message>
    <message>
        <source>nothing can be cut</source>
        <translation>nichts lässt sich abtragen</translation>
    </message>
    <message>
        <source>%1 (%2, limit %3).</source>
        <translation>%1 (%2, Grenze %3).</translation>
    </message>
    <message>
        <source>turned inside out</source>
        <translation>nach innen gewendet</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n triangle(s), %2, %3 mm</source>
        <translation>
            <numerusform>%1: %n Dreieck, %2, %3 mm</numerusform>
            <numerusform>%1: %n Dreiecke, %2, %3 mm</numerusform>
        </translation>
    </message>
    <message>
        <source>gap of %1 mm at %2, %3, %4 mm</source>
        <translation>Lücke von %1 mm bei %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels of %4 × %5 × %6 mm</source>
        <translation>%1 × %2 × %3 Voxel zu %4 × %5 × %6 mm</translation>
    </message>
    <message>
        <source>The file does not give the size of a voxel; --unit-mm does.</source>
        <translation>Die Datei enthält keine Voxelgröße; --unit-mm gibt sie an.</translation>
    </message>
    <message>
        <source>Grey values from %1 to %2</source>
        <translation>Grauwerte von %1 bis %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n voxel(s)</source>
        <translation>
            <numerusform>%1: %n Voxel</numerusform>
            <numerusform>%1: %n Voxel</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is no label of a volume: it takes its number.</source>
        <translation>%1 ist kein Kennwert eines Volumens: er wird als Zahl angegeben.</translation>
    </message>
    <message>
        <source>%1 is not TISSUE=VALUE, such as dentine=1200.</source>
        <translation>%1 ist nicht TISSUE=VALUE, etwa dentine=1200.</translation>
    </message>
    <message>
        <source>Make a specimen volume of closed meshes, of a label volume or of a CT series</source>
        <translation>Aus geschlossenen Netzen, einem Volumen mit Kennwerten oder einer CT-Serie ein Volumen machen</translation>
    </message>
    <message>
        <source>Volume to write (NRRD, or binvox by its ending)</source>
        <translation>Volumen, das geschrieben wird (NRRD, oder binvox nach der Endung)</translation>
    </message>
    <message>
        <source>What a mesh or a label is made of; once for each to be taken</source>
        <translation>Woraus ein Netz oder Kennwert besteht; einmal für jeden, der übernommen wird</translation>
    </message>
    <message>
        <source>The tissue from a grey value on, up to the next; “empty” leaves out</source>
        <translation>Das Gewebe ab einem Grauwert, bis zum nächsten; „empty“ lässt weg</translation>
    </message>
    <message>
        <source>What closed hollows of a volume are made of</source>
        <translation>Woraus geschlossene Hohlräume eines Volumens bestehen</translation>
    </message>
    <message>
        <source>Of a volume keep only the largest connected component</source>
        <translation>Von einem Volumen nur die größte Zusammenhangskomponente behalten</translation>
    </message>
    <message>
        <source>Edge of a voxel in millimetres; 0.1 for meshes, the file’s own for volumes</source>
        <translation>Kantenlänge eines Voxels in Millimetern; 0,1 bei Netzen, die der Datei bei Volumen</translation>
    </message>
    <message>
        <source>Mend meshes, and close holes up to this width in millimetres</source>
        <translation>Netze ausbessern und Löcher bis zu dieser Breite in Millimetern schließen</translation>
    </message>
    <message>
        <source>Only list what the file holds</source>
        <translation>Nur auflisten, was die Datei enthält</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>start, s</source>
        <translation>Start, s</translation>
    </message>
    <message>
        <source>force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>as it is set</source>
        <translation>wie eingestellt</translation>
    </message>
    <message>
        <source>This machine does not count instructions, so only times are shown.</source>
        <translation>Dieser Rechner zählt keine Befehle, darum stehen hier nur Zeiten.</translation>
    </message>
    <message>
        <source>%1 is built in: --apply needs -o FILE for the copy.</source>
        <translation>%1 ist mitgeliefert: --apply braucht -o FILE für die Kopie.</translation>
    </message>
    <message>
        <source>-o FILE belongs to --apply.</source>
        <translation>-o FILE gehört zu --apply.</translation>
    </message>
    <message>
        <source>Written to %1 as version %2.</source>
        <translation>Als Version %2 nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Only the size of the voxels: minutes, between neighbouring teeth hours</source>
        <translation>Nur die Größe der Voxel: Minuten, zwischen Nachbarzähnen Stunden</translation>
    </message>
    <message>
        <source>Write the leanest into the scenario, as its next version</source>
        <translation>Das schlankste in die Übung schreiben, als ihre nächste Version</translation>
    </message>
    <message>
        <source>With --apply: write a copy there</source>
        <translation>Mit --apply: dorthin eine Kopie schreiben</translation>
    </message>
    <message>
        <source>Print how far it is to stderr</source>
        <translation>Den Fortschritt auf stderr ausgeben</translation>
    </message>
    <message>
        <source>A scenario.json, its folder, or a built-in one: %1</source>
        <translation>Eine scenario.json, ihr Ordner oder eine mitgelieferte: %1</translation>
    </message>
    <message>
        <source>--device has to be falcon, falcon:NAME or emulated-falcon.</source>
        <translation>--device ist falcon, falcon:NAME oder emulated-falcon.</translation>
    </message>
    <message>
        <source>An emulated Falcon needs a scripted operator by name: expert, novice and so on.</source>
        <translation>Ein nachgebildeter Falcon braucht einen automatischen Operateur mit Namen: expert, novice und so weiter.</translation>
    </message>
    <message>
        <source>With the emulated Falcon: it answers nothing for 50 ms every so many seconds</source>
        <translation>Mit dem nachgebildeten Falcon: Er antwortet alle so viele Sekunden 50 ms lang nicht</translation>
    </message>
    <message>
        <source>Number or user name of the account to act as; its password or PIN comes from CUSP_PASSWORD or stdin. Without it: the student demo</source>
        <translation>Nummer oder Benutzername des Kontos, das handelt; Passwort oder PIN kommen aus CUSP_PASSWORD oder der Standardeingabe. Ohne Angabe: demo</translation>
    </message>
    <message>
        <source>Look at: history DB verify.</source>
        <translation>Siehe: history DB verify.</translation>
    </message>
    <message>
        <source>The counter beside the station’s key lags behind: %1. What was recorded is kept; the counter catches up later.</source>
        <translation>Der Zähler neben dem Schlüssel der Station bleibt zurück: %1. Was aufgezeichnet wurde, ist erhalten; der Zähler holt später auf.</translation>
    </message>
    <message>
        <source>Number %1 and PIN do not match.</source>
        <translation>Nummer %1 und PIN passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Number %1 and password do not match.</source>
        <translation>Nummer %1 und Passwort passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Password or PIN: </source>
        <translation>Passwort oder PIN: </translation>
    </message>
    <message>
        <source>PIN: </source>
        <translation>PIN: </translation>
    </message>
    <message>
        <source>Nothing is sealed yet: that begins when the database is next opened for writing.</source>
        <translation>Noch ist nichts versiegelt: Das beginnt, wenn die Datenbank das nächste Mal zum Schreiben geöffnet wird.</translation>
    </message>
    <message>
        <source>Sealed since %1; what was there before is held against what it was then.</source>
        <translation>Versiegelt seit %1; was vorher da war, wird mit dem Stand von damals verglichen.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry/entries of the audit log are not yet in the counter beside the key.</source>
        <translation>
            <numerusform>%n Eintrag des Protokolls steht noch nicht im Zähler neben dem Schlüssel.</numerusform>
            <numerusform>%n Einträge des Protokolls stehen noch nicht im Zähler neben dem Schlüssel.</numerusform>
        </translation>
    </message>
    <message>
        <source>--scale takes the factor.</source>
        <translation>--scale nimmt den Faktor.</translation>
    </message>
    <message>
        <source>%1 is no precedence: innermost or given.</source>
        <translation>%1 ist kein Vorrang: innermost oder given.</translation>
    </message>
    <message>
        <source>--turn takes x, y, z, -x, -y or -z.</source>
        <translation>--turn nimmt x, y, z, -x, -y oder -z.</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3DS, OFF (several are put together), NRRD, MetaImage, NIfTI, binvox, or a folder of DICOM slices</source>
        <translation>STL, OBJ, PLY, 3DS, OFF (mehrere werden zusammengefügt), NRRD, MetaImage, NIfTI, binvox oder ein Ordner mit DICOM-Schichten</translation>
    </message>
    <message>
        <source>Factor on the unit, as 0.1 for a tooth that came in ten times too long</source>
        <translation>Faktor auf die Einheit, etwa 0.1 für einen Zahn, der zehnmal zu lang ankam</translation>
    </message>
    <message>
        <source>A quarter turn of what was made about this axis, by the right hand; -x turns back; may be repeated</source>
        <translation>Eine Vierteldrehung des Ergebnisses um diese Achse, nach der rechten Hand; -x dreht zurück; mehrmals möglich</translation>
    </message>
    <message>
        <source>Which mesh wins where several overlap: the innermost one, or the first --tissue given</source>
        <translation>Welches Netz gilt, wo sich mehrere überschneiden: das innerste (innermost) oder das erste angegebene --tissue (given)</translation>
    </message>
    <message>
        <source>Stopped. Nothing was changed.</source>
        <translation>Angehalten. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Only up to this moment of the session, in seconds</source>
        <translation>Nur bis zu diesem Zeitpunkt des Versuchs, in Sekunden</translation>
    </message>
    <message>
        <source>Write the tooth as it is then (NRRD)</source>
        <translation>Den Zahn schreiben, wie er dann ist (NRRD)</translation>
    </message>
    <message>
        <source>a criterion brings less than a twentieth of a point</source>
        <translation>ein Kriterium bringt weniger als ein Zwanzigstel eines Punkts</translation>
    </message>
    <message>
        <source>the target opens the pulp</source>
        <translation>das Ziel eröffnet die Pulpa</translation>
    </message>
    <message>
        <source>the target holds pulp, as the access to a root canal does</source>
        <translation>das Ziel enthält Pulpa, wie die Zugangskavität zu einem Wurzelkanal</translation>
    </message>
    <message>
        <source>opening the pulp does not fail the attempt</source>
        <translation>eine eröffnete Pulpa lässt den Versuch nicht scheitern</translation>
    </message>
    <message>
        <source>the tolerance zone reaches the pulp</source>
        <translation>die Toleranzzone erreicht die Pulpa</translation>
    </message>
    <message>
        <source>the target takes a protected tissue (%1)</source>
        <translation>das Ziel trägt ein geschütztes Gewebe ab (%1)</translation>
    </message>
    <message>
        <source>the tolerance zone reaches a protected tissue (%1)</source>
        <translation>die Toleranzzone erreicht ein geschütztes Gewebe (%1)</translation>
    </message>
    <message>
        <source>the target holds nothing that could be cut</source>
        <translation>das Ziel enthält nichts, was abgetragen werden könnte</translation>
    </message>
    <message>
        <source>an attempt that cuts nothing earns points</source>
        <translation>ein Versuch, der nichts abträgt, bringt Punkte</translation>
    </message>
    <message>
        <source>an attempt that cuts a twentieth of the target passes</source>
        <translation>ein Versuch, der ein Zwanzigstel des Ziels abträgt, besteht</translation>
    </message>
    <message>
        <source>the text is still that of the exercise it was copied from (%1)</source>
        <translation>der Text ist noch der der Übung, von der er kopiert wurde (%1)</translation>
    </message>
    <message>
        <source>the title names another tooth (%1)</source>
        <translation>der Titel nennt einen anderen Zahn (%1)</translation>
    </message>
    <message>
        <source>the text names a length that the target has not (%1)</source>
        <translation>der Text nennt eine Länge, die das Ziel nicht hat (%1)</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>%1 belongs to the database %2.</source>
        <translation>%1 gehört zur Datenbank %2.</translation>
    </message>
    <message>
        <source>Nothing was written. Give another name.</source>
        <translation>Es wurde nichts geschrieben. Einen anderen Namen angeben.</translation>
    </message>
    <message>
        <source>µs: CPU time of an update; below the first row what it takes more or less. Force: rms and most of its change on the same path. Score: the largest change of an operator’s attempt.</source>
        <translation>µs: Rechenzeit eines Schritts; unter der ersten Zeile, was er mehr oder weniger braucht. Kraft: quadratisches Mittel und größter Wert ihrer Änderung auf demselben Weg. Punkte: die größte Änderung eines Versuchs.</translation>
    </message>
    <message>
        <source>What each part of an exercise’s model costs and changes, and the leanest model that grades the same; scripted operators drill it many times, which takes minutes</source>
        <translation>Was jeder Teil vom Modell einer Übung kostet und ändert, und das schlankste Modell mit gleichen Punkten; automatische Operateure spielen sie viele Male, was Minuten dauert</translation>
    </message>
    <message>
        <source>Attempts of each scripted operator: expert, competent and novice</source>
        <translation>Versuche jedes automatischen Operateurs: expert, competent und novice</translation>
    </message>
    <message>
        <source>Let a scripted operator do an exercise: keeps the session and writes report.json, report.pdf and tooth.png; prints the session&apos;s id</source>
        <translation>Einen automatischen Operateur eine Übung machen lassen: bewahrt den Versuch auf und schreibt report.json, report.pdf und tooth.png; gibt seine Kennung aus</translation>
    </message>
    <message>
        <source>Play in real time on a device: falcon, falcon:NAME (held by a person) or emulated-falcon (led by the scripted operator)</source>
        <translation>In Echtzeit an einem Gerät spielen: falcon, falcon:NAME (ein Mensch hält es) oder emulated-falcon (der automatische Operateur führt es)</translation>
    </message>
    <message>
        <source>With --device: end after so many seconds of the session; the scripted operator begins anew meanwhile</source>
        <translation>Mit --device: nach so vielen Sekunden des Versuchs enden; der automatische Operateur beginnt so lange von vorn</translation>
    </message>
    <message>
        <source>Carious lesion: fissure, proximal or root, then its place, radius and depth in millimetres, and softness from 0 to 1</source>
        <translation>Kariöse Läsion: fissure, proximal oder root, dann Ort, Radius und Tiefe in Millimetern und Weichheit von 0 bis 1</translation>
    </message>
    <message>
        <source>the tolerance zone is thinner than a voxel</source>
        <translation>die Toleranzzone ist dünner als ein Voxel</translation>
    </message>
    <message>
        <source>an attempt that meets the target loses points</source>
        <translation>ein Versuch, der das Ziel trifft, verliert Punkte</translation>
    </message>
    <message>
        <source>Grade this prepared volume of the scenario&apos;s specimen (NRRD). Shown, not stored</source>
        <translation>Dieses präparierte Volumen des Präparats der Übung bewerten (NRRD). Wird gezeigt, nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 has voxels of %2 mm, the exercise’s specimen of %3 mm.</source>
        <translation>%1 hat Voxel von %2 mm, das Präparat der Übung von %3 mm.</translation>
    </message>
    <message>
        <source>The voxels of %1 lie between those of the exercise’s specimen: it is in another frame.</source>
        <translation>Die Voxel von %1 liegen zwischen denen des Präparats der Übung: Das Koordinatensystem ist ein anderes.</translation>
    </message>
    <message>
        <source>%1 is of another specimen: %2 mm³ of it stand where this exercise’s specimen has no tissue.</source>
        <translation>%1 gehört zu einem anderen Präparat: %2 mm³ davon stehen, wo das Präparat dieser Übung kein Gewebe hat.</translation>
    </message>
    <message>
        <source>The surface of %1 is not that of the exercise’s specimen. A volume of labels knows it to half a voxel only: give one with distances, as cusp replay --volume writes it.</source>
        <translation>Die Oberfläche von %1 ist nicht die des Präparats der Übung. Ein Volumen mit Kennwerten gibt sie nur auf ein halbes Voxel genau an: Geben Sie eines mit Abständen an, wie cusp replay --volume es schreibt.</translation>
    </message>
    <message>
        <source>In %1 more is cut than a volume of this exercise can keep.</source>
        <translation>In %1 ist mehr abgetragen, als ein Volumen dieser Übung aufnehmen kann.</translation>
    </message>
    <message>
        <source>a shape of the target has no direction</source>
        <translation>eine Form des Ziels hat keine Richtung</translation>
    </message>
    <message>
        <source>the target has no end on a side</source>
        <translation>das Ziel hat auf einer Seite kein Ende</translation>
    </message>
    <message>
        <source>damage of a protected part fails the attempt, and nothing is protected</source>
        <translation>Verletzung von Geschütztem lässt den Versuch scheitern, und nichts ist geschützt</translation>
    </message>
    <message>
        <source>No bur of the exercise fits into its target.</source>
        <translation>Kein Bohrer der Übung passt in ihr Ziel.</translation>
    </message>
    <message>
        <source>--as belongs to a database; --volume and --operator need no account.</source>
        <translation>--as gehört zu einer Datenbank; --volume und --operator brauchen kein Konto.</translation>
    </message>
    <message>
        <source>Give a database and a session, or a scenario and either --volume or --operator.</source>
        <translation>Geben Sie eine Datenbank und einen Versuch an, oder eine Übung und entweder --volume oder --operator.</translation>
    </message>
    <message>
        <source>Run a stored session again and grade it as it stands, or grade a volume or an operator&apos;s cuts; an interrupted session keeps its grade</source>
        <translation>Einen gespeicherten Versuch erneut rechnen und bewerten, wie er ist, oder ein Volumen oder den Abtrag eines automatischen Operateurs bewerten; ein unterbrochener Versuch behält seine Bewertung</translation>
    </message>
    <message>
        <source>Database; with --volume or --operator a scenario.json, its folder, or a built-in one</source>
        <translation>Datenbank; mit --volume oder --operator eine scenario.json, ihr Ordner oder eine mitgelieferte</translation>
    </message>
    <message>
        <source>Cut the scenario&apos;s specimen as this operator would, at once, and grade that: reference, competent, novice, too_deep, too_shallow, off_outline or pulp; or the reference with one fault, small, medium or large, such as too_deep:small. Faults: %1. Shown, not stored</source>
        <translation>Das Präparat der Übung auf einmal so abtragen, wie dieser Operateur es täte, und das bewerten: reference, competent, novice, too_deep, too_shallow, off_outline oder pulp; oder reference mit einem einzigen Fehler, small, medium oder large, etwa too_deep:small. Fehler: %1. Wird gezeigt, nicht gespeichert</translation>
    </message>
    <message>
        <source>More is cut than a volume of this exercise can keep.</source>
        <translation>Es ist mehr abgetragen, als ein Volumen dieser Übung fassen kann.</translation>
    </message>
    <message>
        <source>This exercise cannot have the fault %1: it has nothing to make it on.</source>
        <translation>Den Fehler %1 kann es in dieser Übung nicht geben: Es fehlt, woran man ihn machen könnte.</translation>
    </message>
    <message>
        <source>%1 is no template: cusp template list names them.</source>
        <translation>%1 ist keine Vorlage: cusp template list nennt sie.</translation>
    </message>
    <message>
        <source>Tooth %1 is no premolar or molar.</source>
        <translation>Zahn %1 ist kein Prämolar oder Molar.</translation>
    </message>
    <message>
        <source>The template has no parameter %1.</source>
        <translation>Die Vorlage hat keinen Parameter %1.</translation>
    </message>
    <message>
        <source>%1 has to be within %2.</source>
        <translation>%1 muss innerhalb von %2 liegen.</translation>
    </message>
    <message>
        <source>The tooth lacks what the template is laid along: %1.</source>
        <translation>Dem Zahn fehlt, woran sich die Vorlage ausrichtet: %1.</translation>
    </message>
    <message>
        <source>These values make no exercise: %1 (%2).</source>
        <translation>Diese Werte ergeben keine Übung: %1 (%2).</translation>
    </message>
    <message>
        <source>The template is broken at %1 (%2).</source>
        <translation>Die Vorlage ist bei %1 fehlerhaft (%2).</translation>
    </message>
    <message>
        <source>Exercises from templates: a preparation fitted to a tooth by its landmarks</source>
        <translation>Übungen aus Vorlagen: eine Präparation, nach seinen Landmarken an einen Zahn angepasst</translation>
    </message>
    <message>
        <source>The templates, and the parameters of each</source>
        <translation>Die Vorlagen und die Parameter einer jeden</translation>
    </message>
    <message>
        <source>Write the exercise of a template on a tooth: scenario.json in DIR</source>
        <translation>Die Übung einer Vorlage an einem Zahn schreiben: scenario.json in DIR</translation>
    </message>
    <message>
        <source>The template&apos;s key</source>
        <translation>Der Schlüssel der Vorlage</translation>
    </message>
    <message>
        <source>FDI number of a premolar or molar</source>
        <translation>FDI-Nummer eines Prämolaren oder Molaren</translation>
    </message>
    <message>
        <source>A parameter&apos;s value; may be given many times</source>
        <translation>Der Wert eines Parameters; kann mehrmals angegeben werden</translation>
    </message>
    <message>
        <source>Folder for scenario.json</source>
        <translation>Ordner für scenario.json</translation>
    </message>
    <message>
        <source>the expected time is longer than the time limit</source>
        <translation>die erwartete Zeit ist länger als die Zeitgrenze</translation>
    </message>
    <message numerus="yes">
        <source>The lists are made anew from the records; %n value(s) differed.</source>
        <translation>
            <numerusform>Die Listen sind aus den Aufzeichnungen neu hergestellt; %n Wert wich ab.</numerusform>
            <numerusform>Die Listen sind aus den Aufzeichnungen neu hergestellt; %n Werte wichen ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes what lists and charts show anew from the records</source>
        <translation>Stellt aus den Aufzeichnungen neu her, was Listen und Diagramme zeigen</translation>
    </message>
    <message>
        <source>%1 is no whole backup.</source>
        <translation>%1 ist keine vollständige Sicherung.</translation>
    </message>
    <message>
        <source>%1 is there already. Restore to a new name; nothing was changed.</source>
        <translation>%1 gibt es schon. Wählen Sie einen neuen Namen; nichts wurde geändert.</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) are restored as of %1.</source>
        <translation>
            <numerusform>%n Versuch ist wiederhergestellt, Stand %1.</numerusform>
            <numerusform>%n Versuche sind wiederhergestellt, Stand %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copies all records as of now to a new folder; for administrators</source>
        <translation>Kopiert alle Aufzeichnungen von jetzt in einen neuen Ordner; für die Verwaltung</translation>
    </message>
    <message>
        <source>Where the backup’s own folder is made</source>
        <translation>Wo der Ordner der Sicherung entsteht</translation>
    </message>
    <message>
        <source>Makes a new database from a backup</source>
        <translation>Macht aus einer Sicherung eine neue Datenbank</translation>
    </message>
    <message>
        <source>The backup’s folder</source>
        <translation>Ordner der Sicherung</translation>
    </message>
    <message>
        <source>Database that does not exist yet</source>
        <translation>Datenbank, die es noch nicht gibt</translation>
    </message>
    <message>
        <source>The person is erased. The attempts stay under the pseudonym %1.</source>
        <translation>Die Person ist gelöscht. Die Versuche bleiben unter dem Pseudonym %1.</translation>
    </message>
    <message>
        <source>Takes a person’s name, number and texts out for good; for administrators</source>
        <translation>Löscht Name, Nummer und Texte einer Person endgültig; für die Verwaltung</translation>
    </message>
    <message>
        <source>The person’s number</source>
        <translation>Nummer der Person</translation>
    </message>
    <message>
        <source>A scenario.json, its folder, an exercise saved as a file, or a built-in one</source>
        <translation>Eine scenario.json, ihr Ordner, eine als Datei gespeicherte Übung oder eine mitgelieferte</translation>
    </message>
    <message>
        <source>The signature does not belong to this pack.</source>
        <translation>Die Signatur gehört nicht zu dieser Akte.</translation>
    </message>
    <message>
        <source>%1 is not as it was signed.</source>
        <translation>%1 ist nicht so, wie es signiert wurde.</translation>
    </message>
    <message>
        <source>Nothing was changed since this pack was made on %1; key %2.</source>
        <translation>Nichts wurde geändert, seit diese Akte am %1 angelegt wurde; Schlüssel %2.</translation>
    </message>
    <message>
        <source>Saves an attempt as an appeal pack, one file that another station verifies; for staff</source>
        <translation>Speichert einen Versuch als Einspruchsakte, eine Datei, die eine andere Station prüft; für das Personal</translation>
    </message>
    <message>
        <source>Verifies an appeal pack: its signature, its files, and its records</source>
        <translation>Prüft eine Einspruchsakte: Signatur, Dateien und Aufzeichnungen</translation>
    </message>
    <message>
        <source>NAME.cusppack</source>
        <translation>NAME.cusppack</translation>
    </message>
    <message>
        <source>Database that may know the key of the pack</source>
        <translation>Datenbank, die den Schlüssel der Akte vielleicht kennt</translation>
    </message>
    <message>
        <source>Also compute the attempt anew, and compare tooth and grade bit for bit</source>
        <translation>Den Versuch auch neu berechnen und Zahn und Bewertung Bit für Bit vergleichen</translation>
    </message>
    <message>
        <source>Key %1. The other station’s administrator compares it before trusting %2.</source>
        <translation>Schlüssel %1. Wer die andere Station verwaltet, vergleicht ihn, bevor %2 vertraut wird.</translation>
    </message>
    <message>
        <source>Files under key %1 are no longer read.</source>
        <translation>Dateien unter dem Schlüssel %1 werden nicht mehr eingelesen.</translation>
    </message>
    <message>
        <source>Files under key %1 are read from now on.</source>
        <translation>Dateien unter dem Schlüssel %1 werden ab jetzt eingelesen.</translation>
    </message>
    <message>
        <source>Either --office or --results says what the file carries.</source>
        <translation>Entweder --office oder --results sagt, was die Datei enthält.</translation>
    </message>
    <message>
        <source>File %1 under key %2: %3.</source>
        <translation>Datei %1 unter dem Schlüssel %2: %3.</translation>
    </message>
    <message>
        <source>Files from station to station, without a server; for administrators</source>
        <translation>Dateien von Station zu Station, ohne Server; für die Verwaltung</translation>
    </message>
    <message>
        <source>Writes this station’s public key, for others to trust</source>
        <translation>Schreibt den öffentlichen Schlüssel dieser Station, damit andere ihm vertrauen</translation>
    </message>
    <message>
        <source>Where the key is written</source>
        <translation>Wohin der Schlüssel geschrieben wird</translation>
    </message>
    <message>
        <source>Lists the other stations’ keys that are known here</source>
        <translation>Listet die hier bekannten Schlüssel anderer Stationen</translation>
    </message>
    <message>
        <source>Makes a station’s key known here, after its fingerprint was compared</source>
        <translation>Macht den Schlüssel einer Station hier bekannt, nachdem sein Fingerabdruck verglichen wurde</translation>
    </message>
    <message>
        <source>A key that “exchange key” wrote</source>
        <translation>Ein Schlüssel, den „exchange key“ geschrieben hat</translation>
    </message>
    <message>
        <source>Its files may also bring accounts, cohorts, assignments and exercises</source>
        <translation>Ihre Dateien dürfen auch Konten, Kohorten, Zuweisungen und Übungen bringen</translation>
    </message>
    <message>
        <source>No longer read files under this key</source>
        <translation>Dateien unter diesem Schlüssel nicht mehr einlesen</translation>
    </message>
    <message>
        <source>Writes a signed file for other stations</source>
        <translation>Schreibt eine signierte Datei für andere Stationen</translation>
    </message>
    <message>
        <source>A new file</source>
        <translation>Eine neue Datei</translation>
    </message>
    <message>
        <source>Accounts, cohorts, assignments, exercises and statements of this station</source>
        <translation>Konten, Kohorten, Zuweisungen, Übungen und Erklärungen dieser Station</translation>
    </message>
    <message>
        <source>Attempts and statements of this station</source>
        <translation>Versuche und Erklärungen dieser Station</translation>
    </message>
    <message>
        <source>Reads another station’s file whole, or changes nothing</source>
        <translation>Liest die Datei einer anderen Station ganz ein, oder ändert nichts</translation>
    </message>
    <message>
        <source>A file that “exchange out” wrote</source>
        <translation>Eine Datei, die „exchange out“ geschrieben hat</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) would be erased.</source>
        <translation>
            <numerusform>%n Person würde gelöscht.</numerusform>
            <numerusform>%n Personen würden gelöscht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) are erased.</source>
        <translation>
            <numerusform>%n Person ist gelöscht.</numerusform>
            <numerusform>%n Personen sind gelöscht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) stay: an assessment of theirs is not released.</source>
        <translation>
            <numerusform>%n Person bleibt: Eine ihrer Prüfungen ist nicht freigegeben.</numerusform>
            <numerusform>%n Personen bleiben: Je eine ihrer Prüfungen ist nicht freigegeben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Erases students who have made no attempt for years; for administrators</source>
        <translation>Löscht Studierende, die seit Jahren keinen Versuch gemacht haben; für die Verwaltung</translation>
    </message>
    <message>
        <source>Years without an attempt, as the school has decided</source>
        <translation>Jahre ohne Versuch, wie die Schule es festgelegt hat</translation>
    </message>
    <message>
        <source>Only say who would be erased</source>
        <translation>Nur sagen, wer gelöscht würde</translation>
    </message>
    <message>
        <source>Stopped before the last recording. Every recording is whole or thinned.</source>
        <translation>Vor der letzten Aufzeichnung angehalten. Jede Aufzeichnung ist vollständig oder ausgedünnt.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) cannot be verified and stayed as they are, %1 first: %2</source>
        <translation>
            <numerusform>%n Versuch ist nicht nachweisbar unverändert und bleibt, wie er ist, %1: %2</numerusform>
            <numerusform>%n Versuche sind nicht nachweisbar unverändert und bleiben, wie sie sind, zuerst %1: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Takes the recordings of old practice attempts out; grades and final teeth stay; for administrators</source>
        <translation>Entfernt die Aufzeichnungen alter Trainingsversuche; Bewertungen und fertige Zähne bleiben; für die Verwaltung</translation>
    </message>
    <message>
        <source>Days since an attempt ended</source>
        <translation>Tage seit dem Ende eines Versuchs</translation>
    </message>
    <message>
        <source>Only say what would go, and what stays and why</source>
        <translation>Nur sagen, was entfernt würde, und was warum bleibt</translation>
    </message>
    <message>
        <source>The file does not hold what the template needs: %1.</source>
        <translation>Die Datei enthält nicht, was die Vorlage braucht: %1.</translation>
    </message>
    <message>
        <source>The tooth lies %1 degrees off: x has to be mesial or distal, y buccal, z occlusal.</source>
        <translation>Der Zahn liegt um %1 Grad verdreht: x muss mesial oder distal sein, y bukkal, z okklusal.</translation>
    </message>
    <message>
        <source>%1 is no tooth’s number.</source>
        <translation>%1 ist keine Zahnnummer.</translation>
    </message>
    <message>
        <source>%1 holds no tooth.</source>
        <translation>%1 enthält keinen Zahn.</translation>
    </message>
    <message>
        <source>A tooth of your own (NRRD), its landmarks proposed; it is copied to DIR</source>
        <translation>Ein eigener Zahn (NRRD), seine Landmarken werden vorgeschlagen; er wird nach DIR kopiert</translation>
    </message>
    <message>
        <source>the tooth is turned from its frame</source>
        <translation>der Zahn ist verdreht</translation>
    </message>
    <message>
        <source>the tooth is tilted</source>
        <translation>der Zahn ist gekippt</translation>
    </message>
    <message>
        <source>a landmark does not lie on the tooth (%1)</source>
        <translation>eine Landmarke liegt nicht auf dem Zahn (%1)</translation>
    </message>
    <message>
        <source>Attempts with results, cohort and dates as CSV or JSON; for instructors and administrators</source>
        <translation>Versuche mit Ergebnissen, Kohorte und Datum als CSV oder JSON; für Lehrkräfte und Verwaltung</translation>
    </message>
    <message>
        <source>CSV file to write, or - for stdout, where it also goes without -o and --json</source>
        <translation>CSV-Datei, die geschrieben wird; - für die Standardausgabe, wohin sie auch ohne -o und --json geht</translation>
    </message>
    <message>
        <source>Only students who are in this cohort now</source>
        <translation>Nur Studierende, die jetzt in dieser Kohorte sind</translation>
    </message>
    <message>
        <source>Only attempts begun on this day or later, in UTC: 2026-11-20 or 2026-11-20T09:14:03Z</source>
        <translation>Nur Versuche, die an diesem Tag oder später begannen, in UTC: 2026-11-20 oder 2026-11-20T09:14:03Z</translation>
    </message>
    <message>
        <source>Only attempts begun on this day or earlier</source>
        <translation>Nur Versuche, die an diesem Tag oder früher begannen</translation>
    </message>
    <message>
        <source>Only attempts at this exercise: its key or id</source>
        <translation>Nur Versuche dieser Übung: ihr Schlüssel oder ihre Kennung</translation>
    </message>
    <message>
        <source>Only attempts at this version of the exercise</source>
        <translation>Nur Versuche dieser Version der Übung</translation>
    </message>
    <message>
        <source>Only attempts with this result</source>
        <translation>Nur Versuche mit diesem Ergebnis</translation>
    </message>
    <message>
        <source>Only attempts with a device of this class</source>
        <translation>Nur Versuche mit einem Gerät dieser Klasse</translation>
    </message>
    <message>
        <source>“%1” is no date: write it as 2026-11-20 or 2026-11-20T09:14:03Z, in UTC.</source>
        <translation>„%1“ ist kein Datum: Schreiben Sie es als 2026-11-20 oder 2026-11-20T09:14:03Z, in UTC.</translation>
    </message>
    <message>
        <source>--from %1 is after --to %2.</source>
        <translation>--from %1 liegt nach --to %2.</translation>
    </message>
    <message>
        <source>There is no attempt at an exercise “%1”.</source>
        <translation>Es gibt keinen Versuch einer Übung „%1“.</translation>
    </message>
    <message>
        <source>No cohort is called “%1”.</source>
        <translation>Keine Kohorte heißt „%1“.</translation>
    </message>
    <message>
        <source>There is no attempt with a device of class “%1”.</source>
        <translation>Es gibt keinen Versuch mit einem Gerät der Klasse „%1“.</translation>
    </message>
    <message>
        <source>Only one of CSV and JSON can go to stdout.</source>
        <translation>Nur CSV oder JSON kann in die Standardausgabe gehen.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) exported.</source>
        <translation>
            <numerusform>%n Versuch exportiert.</numerusform>
            <numerusform>%n Versuche exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>A gradebook reads CSV alone: --gradebook goes without --json.</source>
        <translation>Ein Notenbuch liest nur CSV: --gradebook und --json gehen nicht zusammen.</translation>
    </message>
    <message>
        <source>The best released result of each student in what is assigned to a cohort, as this system reads it</source>
        <translation>Das beste freigegebene Ergebnis jeder und jedes Studierenden bei einer Zuweisung an eine Kohorte, wie dieses System es liest</translation>
    </message>
    <message>
        <source>The assignment that is due on this day, or none, where the exercise is assigned more than once</source>
        <translation>Die Zuweisung mit dieser Frist, oder none, wo die Übung mehr als einmal zugewiesen ist</translation>
    </message>
    <message>
        <source>“%1” is not assigned to “%2”.</source>
        <extracomment>%3: options as they are typed, such as &quot;--kind practice --due none&quot;.</extracomment>
        <translation>„%1“ ist „%2“ nicht zugewiesen.</translation>
    </message>
    <message>
        <source>There is no display for the window. A verb needs none (see cusp --help).</source>
        <translation>Für das Fenster gibt es keine Anzeige. Ein Befehl braucht keine (siehe cusp --help).</translation>
    </message>
    <message>
        <source>There is no verb %1 (see cusp --help)</source>
        <translation>Den Befehl %1 gibt es nicht (siehe cusp --help)</translation>
    </message>
    <message>
        <source>%1 is no number from 0 on</source>
        <translation>%1 ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>%1 is no number above 0</source>
        <translation>%1 ist keine Zahl über 0</translation>
    </message>
    <message>
        <source>%1 is no whole number from 0 on</source>
        <translation>%1 ist keine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>%1 is no whole number from 1 on</source>
        <translation>%1 ist keine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>A new file, NAME.cusppack</source>
        <translation>Eine neue Datei, NAME.cusppack</translation>
    </message>
    <message>
        <source>%1 has to be 0 or 1.</source>
        <translation>%1 muss 0 oder 1 sein.</translation>
    </message>
    <message>
        <source>With these values nothing is left of the fissures that the preparation follows. A narrower marginal ridge leaves more.</source>
        <translation>Mit diesen Werten bleibt nichts von den Fissuren, denen die Präparation folgt. Eine schmalere Randleiste lässt mehr davon.</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 oder 1</translation>
    </message>
    <message>
        <source>the target holds a tissue that cannot be cut (%1)</source>
        <translation>das Ziel enthält ein Gewebe, das sich nicht abtragen lässt (%1)</translation>
    </message>
    <message>
        <source>an attempt that cuts a twentieth of the target earns points</source>
        <translation>ein Versuch, der ein Zwanzigstel des Ziels abträgt, bringt Punkte</translation>
    </message>
    <message>
        <source>a bur’s head is shorter than 6 voxels</source>
        <translation>der Kopf eines Bohrers ist kürzer als 6 Voxel</translation>
    </message>
    <message>
        <source>only one handpiece can be used at a time</source>
        <translation>nur ein Handstück kann zugleich benutzt werden</translation>
    </message>
    <message>
        <source>vibration and sound need a handpiece (%1)</source>
        <translation>Vibration und Geräusch brauchen ein Handstück (%1)</translation>
    </message>
    <message>
        <source>%1 is graded, and the exercise does not reckon coolant and heat</source>
        <translation>%1 wird bewertet, und die Übung berechnet Kühlung und Wärme nicht</translation>
    </message>
    <message>
        <source>the target is made of a tissue that the tooth does not have (%1)</source>
        <translation>das Ziel besteht aus einem Gewebe, das der Zahn nicht hat (%1)</translation>
    </message>
    <message>
        <source>the target follows a carious lesion, and the tooth has none</source>
        <translation>das Ziel folgt einer kariösen Läsion, und der Zahn hat keine</translation>
    </message>
    <message>
        <source>%1 is of a target that the exercise does not have</source>
        <translation>%1 gehört zu einem Ziel, das die Übung nicht hat</translation>
    </message>
    <message>
        <source>Only this kind; of a gradebook the assignment, where the exercise is assigned more than once</source>
        <translation>Nur diese Art; bei einem Notenbuch die Zuweisung, falls die Übung mehr als einmal zugewiesen ist</translation>
    </message>
    <message>
        <source>“%1” is not assigned to “%2” with %3.</source>
        <translation>„%1“ ist „%2“ nicht mit %3 zugewiesen.</translation>
    </message>
    <message>
        <source>“%1” is assigned to “%2” more than once: say which, by %3.</source>
        <extracomment>%3: options as they are typed, such as &quot;--kind practice --due none&quot;.</extracomment>
        <translation>„%1“ ist „%2“ mehr als einmal zugewiesen: Geben Sie an, welche Zuweisung gemeint ist, mit %3.</translation>
    </message>
    <message>
        <source>not released</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>%1: does not count, changed by %2: %3</source>
        <extracomment>%1: a critical event, %2: an examiner, %3: the reason.</extracomment>
        <translation>%1: zählt nicht, geändert von %2: %3</translation>
    </message>
    <message>
        <source>Measured: %1 of %2 points, %3</source>
        <translation>Gemessen: %1 von %2 Punkten, %3</translation>
    </message>
    <message>
        <source>The station of this database signed it.</source>
        <translation>Die Station dieser Datenbank hat sie signiert.</translation>
    </message>
    <message>
        <source>This database does not know the key: compare it with that of the pack’s station.</source>
        <translation>Diese Datenbank kennt den Schlüssel nicht: Vergleichen Sie ihn mit dem der Station, von der die Akte stammt.</translation>
    </message>
    <message>
        <source>Key %1 is not known here.</source>
        <translation>Der Schlüssel %1 ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is named twice.</source>
        <translation>%1 ist zweimal angegeben.</translation>
    </message>
    <message>
        <source>%1 is set twice.</source>
        <translation>%1 ist zweimal gesetzt.</translation>
    </message>
    <message>
        <source>%1 was changed while it was audited.</source>
        <translation>%1 wurde während der Messung des Aufwands geändert.</translation>
    </message>
    <message>
        <source>Nothing was written: audit it again.</source>
        <translation>Nichts wurde geschrieben: Messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The copy needs %1 beside it.</source>
        <translation>Die Kopie braucht %1 neben sich.</translation>
    </message>
    <message>
        <source>Write it into the exercise’s folder.</source>
        <translation>Schreiben Sie sie in den Ordner der Übung.</translation>
    </message>
    <message>
        <source>--seconds and --silence-every belong to --device.</source>
        <translation>--seconds und --silence-every gehören zu --device.</translation>
    </message>
    <message>
        <source>Stopped. No file was written.</source>
        <translation>Angehalten. Es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>%1 cannot be measured on this specimen with this target</source>
        <translation>%1 lässt sich an diesem Präparat mit diesem Ziel nicht messen</translation>
    </message>
    <message>
        <source>%1 is named twice among what fails the attempt</source>
        <translation>%1 ist zweimal unter dem genannt, was den Versuch scheitern lässt</translation>
    </message>
    <message>
        <source>No bur of the exercise fits into its target while the handpiece is tilted by %1 degrees.</source>
        <translation>Kein Bohrer der Übung passt in ihr Ziel, wenn das Handstück um %1 Grad geneigt ist.</translation>
    </message>
    <message>
        <source>Stopped. What was written may lack attempts.</source>
        <translation>Angehalten. Im Geschriebenen können Versuche fehlen.</translation>
    </message>
    <message>
        <source>Only attempts of students, of staff, or of scripted operators</source>
        <translation>Nur Versuche von Studierenden, von Personal oder von automatischen Operateuren</translation>
    </message>
    <message>
        <source>The standard output cannot be written: %1.</source>
        <translation>Die Standardausgabe kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>If that date is right, add --clock-is-right.</source>
        <translation>Wenn dieses Datum stimmt, geben Sie zusätzlich --clock-is-right an.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Nothing can be written to %1: %2.</source>
        <translation>In %1 lässt sich nichts schreiben: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 instead of %3 point(s), changed by %4: %5</source>
        <extracomment>%1: a criterion, %2: points that count, %3: measured points, %4: an examiner, %5: the reason.</extracomment>
        <translation>
            <numerusform>%1: %2 statt %3 Punkt, geändert von %4: %5</numerusform>
            <numerusform>%1: %2 statt %3 Punkte, geändert von %4: %5</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is protected twice, and what is removed of it counts twice</source>
        <translation>%1 ist zweimal geschützt, und was davon abgetragen wird, zählt doppelt</translation>
    </message>
    <message>
        <source>%1 is no exercise file, NAME.cusp. A verb stands before every option (see cusp --help).</source>
        <translation>%1 ist keine Übungsdatei, NAME.cusp. Ein Befehl steht vor jeder Option (siehe cusp --help).</translation>
    </message>
    <message>
        <source>Only one exercise file can be opened, and %1 is another.</source>
        <translation>Nur eine Übungsdatei kann geöffnet werden, und %1 ist eine weitere.</translation>
    </message>
    <message>
        <source>%1 has no effect: %2 is a specimen’s volume already. Only --turn changes it.</source>
        <translation>%1 bewirkt nichts: %2 ist schon das Volumen eines Präparats. Nur --turn verändert es.</translation>
    </message>
    <message>
        <source>%1 has no effect on a volume, only on meshes.</source>
        <translation>%1 wirkt nicht auf ein Volumen, nur auf Netze.</translation>
    </message>
    <message>
        <source>%1 has no effect on meshes, only on a volume.</source>
        <translation>%1 wirkt nicht auf Netze, nur auf ein Volumen.</translation>
    </message>
    <message>
        <source>An earlier restore to %1 was interrupted. It is now finished; this backup was not restored.</source>
        <translation>Eine frühere Wiederherstellung nach %1 wurde unterbrochen. Sie ist jetzt abgeschlossen; diese Sicherung wurde nicht wiederhergestellt.</translation>
    </message>
    <message>
        <source>%1 has no effect: --list makes nothing.</source>
        <translation>%1 bewirkt nichts: --list erzeugt nichts.</translation>
    </message>
    <message>
        <source>%1 would not be read: a volume is imported alone.</source>
        <translation>%1 würde nicht gelesen: Ein Volumen wird für sich importiert.</translation>
    </message>
    <message>
        <source>%1 is the name of another kind of file: a volume is written as NRRD, or as binvox by its ending.</source>
        <translation>%1 ist der Name einer anderen Art von Datei: Ein Volumen wird als NRRD geschrieben oder, nach seiner Endung, als binvox.</translation>
    </message>
    <message>
        <source>--silence-every belongs to --device emulated-falcon.</source>
        <translation>--silence-every gehört zu --device emulated-falcon.</translation>
    </message>
    <message>
        <source>--script and --seed belong to a scripted operator: a person holds this device.</source>
        <translation>--script und --seed gehören zu einem automatischen Operateur: Dieses Gerät hält ein Mensch.</translation>
    </message>
    <message>
        <source>--seed belongs to a scripted operator, and %1 is none.</source>
        <translation>--seed gehört zu einem automatischen Operateur, und %1 ist keiner.</translation>
    </message>
    <message>
        <source>%1 has no effect on %2.</source>
        <translation>%1 wirkt nicht auf %2.</translation>
    </message>
    <message>
        <source>%1 has no effect on a tooth of plastic: it has no carious lesion.</source>
        <translation>%1 wirkt nicht auf einen Zahn aus Kunststoff: Er hat keine kariöse Läsion.</translation>
    </message>
    <message>
        <source>the value is empty</source>
        <translation>der Wert ist leer</translation>
    </message>
    <message>
        <source>it is written to a file, and - is none</source>
        <translation>es wird in eine Datei geschrieben, und - ist keine</translation>
    </message>
    <message>
        <source>%1 cannot be read.</source>
        <translation>%1 kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Its permissions or those of its folder refuse it. Nothing was changed.</source>
        <translation>Die Rechte der Datei oder ihres Ordners lassen es nicht zu. Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Stopped before the last student. Those who are named are erased.</source>
        <translation>Vor der letzten Person angehalten. Die genannten Personen sind gelöscht.</translation>
    </message>
    <message>
        <source>“%1” is the key of more than one exercise: give the id of one.</source>
        <translation>„%1“ ist der Schlüssel mehrerer Übungen: Geben Sie die Kennung einer von ihnen an.</translation>
    </message>
    <message>
        <source>The verification was stopped.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Attempts verified and whole: %1. The others were not verified.</source>
        <translation>Geprüft und unversehrt: %1 (Versuche). Die übrigen wurden nicht geprüft.</translation>
    </message>
    <message>
        <source>The dates are right, although for more than half a year nothing was recorded</source>
        <translation>Die Datumsangaben stimmen, obwohl mehr als ein halbes Jahr lang nichts aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>If these dates are right, add --clock-is-right.</source>
        <translation>Wenn diese Datumsangaben stimmen, geben Sie zusätzlich --clock-is-right an.</translation>
    </message>
    <message>
        <source>%1 brings no points</source>
        <translation>%1 bringt keine Punkte</translation>
    </message>
    <message>
        <source>%1 is there already, and somebody may have edited it.</source>
        <translation>%1 gibt es schon, und jemand kann es bearbeitet haben.</translation>
    </message>
    <message>
        <source>Nothing was written. Give another folder.</source>
        <translation>Es wurde nichts geschrieben. Einen anderen Ordner angeben.</translation>
    </message>
    <message>
        <source>a region</source>
        <translation>ein Bereich</translation>
    </message>
    <message>
        <source>the catalogue’s bur %1 has another shape or diameter</source>
        <translation>der Bohrer %1 des Katalogs hat eine andere Form oder einen anderen Durchmesser</translation>
    </message>
    <message>
        <source>no bur reaches the floor before its shank touches</source>
        <translation>kein Bohrer erreicht den Boden, bevor sein Schaft anstößt</translation>
    </message>
    <message>
        <source>%1 cannot be measured where tooth and neighbours are of one plastic</source>
        <translation>%1 lässt sich nicht messen, wo Zahn und Nachbarn aus einem Kunststoff sind</translation>
    </message>
    <message>
        <source>a mesial or distal wall of the target stands on the other side of this tooth</source>
        <translation>eine mesiale oder distale Wand des Ziels steht auf der anderen Seite dieses Zahns</translation>
    </message>
    <message>
        <source>the target names mesial and distal walls, and the file does not state where mesial lies</source>
        <translation>das Ziel benennt mesiale und distale Wände, und die Datei gibt nicht an, wo mesial liegt</translation>
    </message>
    <message>
        <source>an attempt that cuts the target and nothing else does not pass</source>
        <translation>ein Versuch, der das Ziel und sonst nichts abträgt, besteht nicht</translation>
    </message>
    <message>
        <source>%1 earns full points whatever is measured</source>
        <translation>%1 bringt volle Punkte, was auch gemessen wird</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ClosingWindow</name>
    <message>
        <source>Cusp is closing</source>
        <translation>Cusp wird geschlossen</translation>
    </message>
    <message>
        <source>Close without waiting</source>
        <translation>Ohne Warten schließen</translation>
    </message>
    <message>
        <source>A file or a change of the records is still being written. If you do not wait, a file that is not finished is missing, and a change that is not made yet is not made. All other records are kept.</source>
        <translation>Eine Datei oder eine Änderung der Aufzeichnungen wird noch geschrieben. Wenn Sie nicht warten, fehlt eine Datei, die nicht fertig ist, und eine Änderung, die noch nicht gemacht ist, wird nicht gemacht. Alle anderen Aufzeichnungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Work in the background has not ended: something is computed, or a drive or a device does not answer. Nothing is lost if you do not wait.</source>
        <translation>Arbeit im Hintergrund ist noch nicht zu Ende: Etwas wird berechnet, oder ein Laufwerk oder ein Gerät antwortet nicht. Wenn Sie nicht warten, geht nichts verloren.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CohortStudentsModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CohortsModel</name>
    <message>
        <source>Cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Studierende</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CohortsPage</name>
    <message>
        <source>Cohorts</source>
        <translation>Kohorten</translation>
    </message>
    <message>
        <source>Name of a new cohort</source>
        <translation>Name einer neuen Kohorte</translation>
    </message>
    <message>
        <source>New cohort</source>
        <translation>Neue Kohorte</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Studierende</translation>
    </message>
    <message>
        <source>Students of the cohort</source>
        <translation>Studierende der Kohorte</translation>
    </message>
    <message>
        <source>Student numbers, one a line; names may stand beside them</source>
        <translation>Matrikelnummern, eine je Zeile; Namen dürfen daneben stehen</translation>
    </message>
    <message>
        <source>Student numbers to add</source>
        <translation>Matrikelnummern zum Aufnehmen</translation>
    </message>
    <message>
        <source>Add students</source>
        <translation>Studierende aufnehmen</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>Assigned exercises</source>
        <translation>Zugewiesene Übungen</translation>
    </message>
    <message>
        <source>No cohort is chosen.</source>
        <translation>Keine Kohorte ist gewählt.</translation>
    </message>
    <message>
        <source>Make one with a name, for a year or a group.</source>
        <translation>Legen Sie eine mit Namen an, für ein Jahr oder eine Gruppe.</translation>
    </message>
    <message>
        <source>A cohort needs a name.</source>
        <translation>Eine Kohorte braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a cohort %1 already.</source>
        <translation>Es gibt schon eine Kohorte %1.</translation>
    </message>
    <message>
        <source>The cohort %1 is made.</source>
        <translation>Die Kohorte %1 ist angelegt.</translation>
    </message>
    <message>
        <source>Paste the numbers of its students below the table.</source>
        <translation>Fügen Sie die Nummern ihrer Studierenden unter der Tabelle ein.</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) were in it already.</source>
        <translation>
            <numerusform>%n war schon darin.</numerusform>
            <numerusform>%n waren schon darin.</numerusform>
        </translation>
    </message>
    <message>
        <source>No student has: %1.</source>
        <translation>Diese Nummern hat niemand: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>Nor %n more.</source>
        <translation>
            <numerusform>Und %n weitere.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) added.</source>
        <translation>
            <numerusform>%n aufgenommen.</numerusform>
            <numerusform>%n aufgenommen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take %1 out of %2?</source>
        <translation>%1 aus %2 herausnehmen?</translation>
    </message>
    <message>
        <source>Account and results are kept. What is assigned to the cohort no longer stands on the student&apos;s start page.</source>
        <translation>Konto und Ergebnisse bleiben. Was der Kohorte zugewiesen ist, steht nicht mehr auf der Startseite.</translation>
    </message>
    <message>
        <source>%1 is taken out.</source>
        <translation>%1 ist herausgenommen.</translation>
    </message>
    <message>
        <source>It would be due before it opens.</source>
        <translation>Die Übung wäre fällig, bevor sie offen ist.</translation>
    </message>
    <message>
        <source>Choose a later day for Due.</source>
        <translation>Wählen Sie einen späteren Tag für „Fällig“.</translation>
    </message>
    <message>
        <source>%1 is assigned to %2.</source>
        <translation>%1 ist %2 zugewiesen.</translation>
    </message>
    <message>
        <source>It stands on the start page of its students.</source>
        <translation>Die Übung steht auf der Startseite der Studierenden.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Start code %1</source>
        <translation>Startcode %1</translation>
    </message>
    <message>
        <source>The start code is %1.</source>
        <translation>Der Startcode ist %1.</translation>
    </message>
    <message>
        <source>No device is admitted.</source>
        <translation>Kein Gerät ist zugelassen.</translation>
    </message>
    <message>
        <source>Check one device at least.</source>
        <translation>Kreuzen Sie mindestens ein Gerät an.</translation>
    </message>
    <message>
        <source>only with %1</source>
        <translation>nur mit %1</translation>
    </message>
    <message>
        <source>No cohort yet</source>
        <translation>Noch keine Kohorte</translation>
    </message>
    <message>
        <source>%1 is assigned to %2 already.</source>
        <translation>%1 ist %2 bereits zugewiesen.</translation>
    </message>
    <message>
        <source>An open assignment has the same kind, days, attempts and devices. Change one of them to assign it again.</source>
        <translation>Eine offene Zuweisung hat dieselbe Art, dieselben Tage, Versuche und Geräte. Ändern Sie etwas davon, um die Übung erneut zuzuweisen.</translation>
    </message>
    <message>
        <source>Its time would be over already.</source>
        <translation>Die Zeit dafür wäre schon vorbei.</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>Withdraw %1?</source>
        <translation>%1 zurückziehen?</translation>
    </message>
    <message>
        <source>No further attempt can begin, and it no longer stands on the start pages of its students. Attempts that were begun can be finished; their results are kept.</source>
        <translation>Es kann kein weiterer Versuch beginnen, und auf den Startseiten der Studierenden steht die Zuweisung nicht mehr. Begonnene Versuche können beendet werden; ihre Ergebnisse bleiben.</translation>
    </message>
    <message>
        <source>%1 is withdrawn.</source>
        <translation>%1 ist zurückgezogen.</translation>
    </message>
    <message>
        <source>It can be assigned again.</source>
        <translation>Die Übung kann wieder zugewiesen werden.</translation>
    </message>
    <message>
        <source>Version %1 of %2 was withdrawn meanwhile: nothing is assigned.</source>
        <translation>Version %1 von %2 wurde inzwischen zurückgezogen: Es ist nichts zugewiesen.</translation>
    </message>
    <message>
        <source>The form has version %1 now. Press Assign to assign that.</source>
        <translation>Im Formular steht jetzt Version %1. Mit „Zuweisen“ weisen Sie diese zu.</translation>
    </message>
    <message>
        <source>The form no longer has this exercise. Choose another one.</source>
        <translation>Das Formular hat diese Übung nicht mehr. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>No student number is there to add.</source>
        <translation>Es steht keine Matrikelnummer zum Hinzufügen da.</translation>
    </message>
    <message>
        <source>Type or paste the numbers, one a line.</source>
        <translation>Tippen Sie die Nummern ein oder fügen Sie sie ein, eine je Zeile.</translation>
    </message>
    <message>
        <source>No exercise is chosen.</source>
        <translation>Keine Übung ist gewählt.</translation>
    </message>
    <message>
        <source>Choose one in the form.</source>
        <translation>Wählen Sie eine im Formular.</translation>
    </message>
    <message>
        <source>The start code could not be read</source>
        <translation>Der Startcode konnte nicht gelesen werden</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Compass</name>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>M</source>
        <comment>mesial</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>D</source>
        <comment>distal</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>B</source>
        <comment>buccal</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>L</source>
        <comment>lingual</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>P</source>
        <comment>palatal</comment>
        <translation>P</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CourseModel</name>
    <message>
        <source>Briefing</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>always open</source>
        <translation>immer offen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keiner</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Fällig</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bestwert</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Model tooth</source>
        <translation>Modellzahn</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>Due %1</source>
        <translation>Fällig %1</translation>
    </message>
    <message>
        <source>no result yet</source>
        <translation>noch kein Ergebnis</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>noch nicht versucht</translation>
    </message>
    <message>
        <source>Class I</source>
        <translation>Klasse I</translation>
    </message>
    <message>
        <source>Class II</source>
        <translation>Klasse II</translation>
    </message>
    <message>
        <source>Caries</source>
        <translation>Karies</translation>
    </message>
    <message>
        <source>Imported specimens</source>
        <translation>Importierte Präparate</translation>
    </message>
    <message>
        <source>Practice blocks</source>
        <translation>Übungsblöcke</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <extracomment>%1: level and expected time of an exercise, %2: the student&apos;s standing at it.</extracomment>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>The time for its assignment is over: a further attempt is kept, but does not count.</source>
        <translation>Die Zeit für die Zuweisung ist um: Ein weiterer Versuch wird aufbewahrt, zählt aber nicht.</translation>
    </message>
    <message>
        <source>Every attempt that counts is used: a further one is kept, but does not count.</source>
        <translation>Alle zählenden Versuche sind verbraucht: Ein weiterer wird aufbewahrt, zählt aber nicht.</translation>
    </message>
    <message>
        <source>Counts only with %1: ask the staff to choose it on the page Device.</source>
        <translation>Zählt nur mit %1: Bitten Sie das Personal, es auf der Seite Gerät zu wählen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CriteriaCard</name>
    <message>
        <source>By criterion</source>
        <translation>Nach Kriterium</translation>
    </message>
    <message>
        <source>graded ones of the newest %1 attempts that fit, the hardest first</source>
        <translation>bewertete unter den neuesten %1 passenden Versuchen, das schwerste zuerst</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CriteriaModel</name>
    <message>
        <source>An edge of the marking is nearer than the figure is known.</source>
        <translation>Eine Grenze der Bewertung liegt näher, als der Wert bekannt ist.</translation>
    </message>
    <message>
        <source>not marked</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>full points</source>
        <translation>volle Punktzahl</translation>
    </message>
    <message>
        <source>points lost</source>
        <translation>Punkte verloren</translation>
    </message>
    <message>
        <source>shows its place on the tooth</source>
        <translation>zeigt die Stelle am Zahn</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Full points</source>
        <translation>Volle Punktzahl</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>counts with the target</source>
        <translation>zählt mit dem Ziel</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (geändert)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>rated as it was measured</source>
        <translation>so eingeschätzt, wie gemessen wurde</translation>
    </message>
    <message>
        <source>rated higher than it was measured</source>
        <translation>höher eingeschätzt, als gemessen wurde</translation>
    </message>
    <message>
        <source>rated lower than it was measured</source>
        <translation>niedriger eingeschätzt, als gemessen wurde</translation>
    </message>
    <message>
        <source>Own rating</source>
        <translation>Einschätzung</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Points of a criterion, and the most it can bring.</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CriterionFiguresModel</name>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Points, mean</source>
        <translation>Punkte, Mittel</translation>
    </message>
    <message>
        <source>With full points</source>
        <translation>Mit vollen Punkten</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
</context>
<context>
    <name>cusp::ui::CutSlider</name>
    <message>
        <source>farther</source>
        <translation>weiter weg</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>How far from the bur the tooth is cut</source>
        <translation>Wie weit vom Bohrer der Zahn geschnitten wird</translation>
    </message>
    <message>
        <source>nearer</source>
        <translation>näher</translation>
    </message>
    <message>
        <source>at the bur</source>
        <translation>am Bohrer</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DepartedCard</name>
    <message>
        <source>Students who left</source>
        <translation>Ehemalige Studierende</translation>
    </message>
    <message>
        <source>as the school decides</source>
        <translation>wie die Schule festlegt</translation>
    </message>
    <message>
        <source>Years without an attempt</source>
        <translation>Jahre ohne Versuch</translation>
    </message>
    <message>
        <source>Erase them</source>
        <translation>Diese löschen</translation>
    </message>
    <message>
        <source>Nobody has been away that long.</source>
        <translation>Niemand ist so lange fort.</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s): %1</source>
        <translation>
            <numerusform>%n Person: %1</numerusform>
            <numerusform>%n Personen: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) stay: an assessment of theirs is not released.</source>
        <translation>
            <numerusform>%n Person bleibt: Eine ihrer Prüfungen ist nicht freigegeben.</numerusform>
            <numerusform>%n Personen bleiben: Je eine ihrer Prüfungen ist nicht freigegeben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Names, numbers and PINs go, and every text about their attempts. The attempts stay under a pseudonym. It cannot be undone; backups made before still hold the names.</source>
        <translation>Namen, Nummern und PINs werden entfernt, ebenso jeder Text über die Versuche. Die Versuche bleiben unter einem Pseudonym. Das lässt sich nicht rückgängig machen; frühere Sicherungen enthalten die Namen noch.</translation>
    </message>
    <message numerus="yes">
        <source>Erase %n student(s) for good?</source>
        <translation>
            <numerusform>%n Person endgültig löschen?</numerusform>
            <numerusform>%n Personen endgültig löschen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) are erased.</source>
        <translation>
            <numerusform>%n Person ist gelöscht.</numerusform>
            <numerusform>%n Personen sind gelöscht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The attempts stay under a pseudonym.</source>
        <translation>Die Versuche bleiben unter einem Pseudonym.</translation>
    </message>
    <message>
        <source>The others are not erased.</source>
        <translation>Die anderen sind nicht gelöscht.</translation>
    </message>
    <message>
        <source>More students have been away that long by now.</source>
        <translation>Inzwischen sind weitere Studierende so lange fort.</translation>
    </message>
    <message>
        <source>Nobody was erased. Check the list, then erase.</source>
        <translation>Niemand wurde gelöscht. Prüfen Sie die Liste und löschen Sie dann.</translation>
    </message>
    <message>
        <source>%1, %2 (%3)</source>
        <comment>name, number (day of the newest attempt)</comment>
        <translation>%1, %2 (%3)</translation>
    </message>
    <message>
        <source>Students who would be erased</source>
        <translation>Personen, die gelöscht würden</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Desktop</name>
    <message>
        <source>There is an administrator by now.</source>
        <translation>Es gibt inzwischen eine Verwaltung.</translation>
    </message>
    <message>
        <source>Another window of Cusp made one. Sign in as that administrator.</source>
        <translation>Ein anderes Fenster von Cusp hat sie angelegt. Melden Sie sich damit an.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistungen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Try it: nothing is kept</source>
        <translation>Ausprobieren: nichts wird aufbewahrt</translation>
    </message>
    <message>
        <source>Opening the report</source>
        <translation>Bericht wird geöffnet</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Try-out: nothing is kept</source>
        <translation>Probelauf: nichts wird aufbewahrt</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Practice, attempt %1, continued</source>
        <translation>Training, Versuch %1, fortgesetzt</translation>
    </message>
    <message>
        <source>Measuring the tooth</source>
        <translation>Der Zahn wird vermessen</translation>
    </message>
    <message>
        <source>Practice, attempt %1</source>
        <translation>Training, Versuch %1</translation>
    </message>
    <message>
        <source>Cohorts</source>
        <translation>Kohorten</translation>
    </message>
    <message>
        <source>Assessment, candidate %1</source>
        <translation>Prüfung, Kandidat/in %1</translation>
    </message>
    <message>
        <source>Assessment, candidate %1, continued</source>
        <translation>Prüfung, Kandidat/in %1, fortgesetzt</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>The daily backup failed.</source>
        <translation>Die tägliche Sicherung ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Save the appeal pack</source>
        <translation>Einspruchsakte speichern</translation>
    </message>
    <message>
        <source>Appeal pack (*.cusppack)</source>
        <translation>Einspruchsakte (*.cusppack)</translation>
    </message>
    <message>
        <source>The appeal pack is being made.</source>
        <translation>Die Einspruchsakte wird angelegt.</translation>
    </message>
    <message>
        <source>Opening the appeal pack</source>
        <translation>Einspruchsakte wird geöffnet</translation>
    </message>
    <message>
        <source>Audit log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>%1 is not open.</source>
        <translation>%1 ist nicht geöffnet.</translation>
    </message>
    <message>
        <source>Instructors open exercise files. Sign out, and sign in as an instructor: the file then opens.</source>
        <translation>Übungsdateien öffnen Lehrkräfte. Melden Sie sich ab und als Lehrkraft an: Dann öffnet sich die Datei.</translation>
    </message>
    <message>
        <source>The records can only be read now, so nothing can be added to the library.</source>
        <translation>Die Aufzeichnungen können jetzt nur gelesen werden, deshalb kann nichts in die Bibliothek kommen.</translation>
    </message>
    <message numerus="yes">
        <source>You were signed out after %n minute(s) without input.</source>
        <translation>
            <numerusform>Sie wurden nach %n Minute ohne Eingabe abgemeldet.</numerusform>
            <numerusform>Sie wurden nach %n Minuten ohne Eingabe abgemeldet.</numerusform>
        </translation>
    </message>
    <message>
        <source>What you did is kept.</source>
        <translation>Was Sie getan haben, bleibt erhalten.</translation>
    </message>
    <message>
        <source>What you did is kept, but for the audit: measure anew.</source>
        <translation>Was Sie getan haben, bleibt erhalten, nur die Messung des Aufwands nicht: Messen Sie neu.</translation>
    </message>
    <message>
        <source>What you did is kept, but for the import: begin it anew.</source>
        <translation>Was Sie getan haben, bleibt erhalten, nur der Import nicht: Beginnen Sie ihn neu.</translation>
    </message>
    <message>
        <source>The next start tries them again.</source>
        <translation>Beim nächsten Start versucht Cusp es wieder.</translation>
    </message>
    <message>
        <source>Nothing can be drilled now.</source>
        <translation>Jetzt kann nicht präpariert werden.</translation>
    </message>
    <message>
        <source>Cusp ended unexpectedly last time. Start without 3D pictures?</source>
        <translation>Cusp wurde beim letzten Mal unerwartet beendet. Ohne 3D-Bilder starten?</translation>
    </message>
    <message>
        <source>Start without 3D pictures</source>
        <translation>Ohne 3D-Bilder starten</translation>
    </message>
    <message>
        <source>Without them this station can grade, replay and administer, and nobody can drill.</source>
        <translation>Ohne sie kann diese Station bewerten, wiedergeben und verwalten; präparieren kann niemand.</translation>
    </message>
    <message>
        <source>Start as usual</source>
        <translation>Wie gewohnt starten</translation>
    </message>
    <message>
        <source>Other stations</source>
        <translation>Andere Stationen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close without the comment?</source>
        <translation>Ohne den Kommentar schließen?</translation>
    </message>
    <message>
        <source>Close without the last edits?</source>
        <translation>Ohne die letzten Änderungen schließen?</translation>
    </message>
    <message>
        <source>The draft of the exercise cannot be saved. The editor shows why.</source>
        <translation>Der Entwurf der Übung lässt sich nicht speichern. Der Editor zeigt, warum.</translation>
    </message>
    <message>
        <source>Some work is not saved.</source>
        <translation>Eine Arbeit ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Not saved yet: the work of %1. It stays here until its owner signs in again, or Cusp ends.</source>
        <translation>Noch nicht gespeichert: die Arbeit von %1. Sie bleibt hier, bis sich dieselbe Person wieder anmeldet oder Cusp endet.</translation>
    </message>
    <message>
        <source>The daily backup is made. An old one could not be removed.</source>
        <translation>Die tägliche Sicherung ist erstellt. Eine alte ließ sich nicht entfernen.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>The comment of %1 waits until its author signs in again.</source>
        <translation>Der Kommentar von %1 wartet, bis sich dieselbe Person wieder anmeldet.</translation>
    </message>
    <message>
        <source>What you did is kept, but for the form that was not saved: fill it in anew.</source>
        <translation>Was Sie getan haben, bleibt erhalten, nur das nicht gespeicherte Formular nicht: Füllen Sie es neu aus.</translation>
    </message>
    <message>
        <source>Close without the import?</source>
        <translation>Ohne den Import schließen?</translation>
    </message>
    <message>
        <source>Close without saving the form?</source>
        <translation>Schließen, ohne das Formular zu speichern?</translation>
    </message>
    <message>
        <source>Grade this attempt as it stands?</source>
        <translation>Diesen Versuch bewerten, wie er ist?</translation>
    </message>
    <message>
        <source>It is then over and cannot be continued.</source>
        <translation>Er ist dann beendet und kann nicht fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>Skip the own assessment?</source>
        <translation>Selbsteinschätzung überspringen?</translation>
    </message>
    <message>
        <source>Your ratings are then not kept, and you cannot rate this attempt later.</source>
        <translation>Ihre Einschätzungen werden dann nicht aufbewahrt, und später können Sie diesen Versuch nicht mehr einschätzen.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>You were signed out: your account is switched off.</source>
        <translation>Sie wurden abgemeldet: Ihr Konto ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>You were signed out: your role was changed. Sign in again.</source>
        <translation>Sie wurden abgemeldet: Ihre Rolle wurde geändert. Melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>What you did is kept, but for the outcome of work that still ran: look how it ended.</source>
        <translation>Was Sie getan haben, bleibt erhalten, nur das Ergebnis dessen, was noch lief, wird nicht mehr angezeigt: Sehen Sie nach, wie es ausging.</translation>
    </message>
    <message>
        <source>The daily backup is being made</source>
        <translation>Die tägliche Sicherung wird gerade erstellt</translation>
    </message>
    <message>
        <source>Cusp closes once it is made. If you leave it out, the next start makes it.</source>
        <translation>Danach schließt sich Cusp. Wenn Sie sie auslassen, wird sie beim nächsten Start erstellt.</translation>
    </message>
    <message>
        <source>Close without the backup</source>
        <translation>Ohne Sicherung schließen</translation>
    </message>
    <message>
        <source>Copying the records</source>
        <translation>Der Datenbestand wird kopiert</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 kopiert</translation>
    </message>
    <message>
        <source>What you did is kept, but for the points that were typed: type them anew.</source>
        <translation>Was Sie getan haben, bleibt erhalten, nur die eingegebenen Punkte nicht: Geben Sie sie neu ein.</translation>
    </message>
    <message>
        <source>Close without the changed points?</source>
        <translation>Ohne die geänderten Punkte schließen?</translation>
    </message>
    <message>
        <source>Close before the work has ended?</source>
        <translation>Schließen, bevor die Arbeit beendet ist?</translation>
    </message>
    <message>
        <source>No appeal pack was saved as %1.</source>
        <translation>Unter %1 wurde keine Einspruchsakte gespeichert.</translation>
    </message>
    <message>
        <source>Practice, attempt %1, not counted</source>
        <translation>Training, Versuch %1, zählt nicht</translation>
    </message>
    <message>
        <source>Nobody manages these records yet.</source>
        <translation>Niemand verwaltet diese Aufzeichnungen bisher.</translation>
    </message>
    <message>
        <source>If this computer takes the place of another one, go back to a backup of that one.</source>
        <translation>Ersetzt dieser Computer einen anderen, gehen Sie zu einer von dessen Sicherungen zurück.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DeviationLegend</name>
    <message>
        <source>on target</source>
        <translation>auf dem Ziel</translation>
    </message>
    <message>
        <source>Over-cut</source>
        <translation>Überpräpariert</translation>
    </message>
    <message>
        <source>Not removed</source>
        <translation>Nicht entfernt</translation>
    </message>
    <message>
        <source>Colours: from %1 not removed, through on target, to %1 over-cut</source>
        <extracomment>%1: a depth with its unit, of both ends.</extracomment>
        <translation>Farben: von %1 nicht entfernt über auf dem Ziel bis %1 überpräpariert</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DevicePage</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Check it before you drill</source>
        <translation>Vor dem Bohren prüfen</translation>
    </message>
    <message>
        <source>What you drill with</source>
        <translation>Womit gebohrt wird</translation>
    </message>
    <message>
        <source>No Falcon is plugged in. One that is plugged in appears here by itself.</source>
        <translation>Kein Falcon ist angeschlossen. Sobald einer angeschlossen wird, erscheint er hier von selbst.</translation>
    </message>
    <message>
        <source>Firmware of the Falcon</source>
        <translation>Firmware des Falcon</translation>
    </message>
    <message>
        <source>A Falcon forgets its firmware when its power is off. Cusp has none: the maker’s licence does not allow it. Name the file that the maker’s software brought to this computer; that licence holds for its use.</source>
        <translation>Ein Falcon vergisst seine Firmware, wenn er keinen Strom hat. Cusp bringt keine mit: Die Lizenz des Herstellers erlaubt es nicht. Nennen Sie die Datei, die mit der Software des Herstellers auf diesen Rechner kam; für sie gilt deren Lizenz.</translation>
    </message>
    <message>
        <source>Name the file…</source>
        <translation>Datei nennen …</translation>
    </message>
    <message>
        <source>Foot pedal</source>
        <translation>Fußpedal</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>not plugged in</source>
        <translation>nicht angeschlossen</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>plugged in</source>
        <translation>angeschlossen</translation>
    </message>
    <message>
        <source>Socket %1</source>
        <translation>Anschluss %1</translation>
    </message>
    <message>
        <source>No file is named.</source>
        <translation>Keine Datei ist genannt.</translation>
    </message>
    <message>
        <source>%1, SHA-256 %2…</source>
        <translation>%1, SHA-256 %2 …</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN)</source>
        <translation>Firmware (*.bin *.BIN)</translation>
    </message>
    <message>
        <source>The file is sound and will be used.</source>
        <translation>Die Datei ist in Ordnung und wird verwendet.</translation>
    </message>
    <message>
        <source>Looking at what is plugged in.</source>
        <translation>Es wird nachgesehen, was angeschlossen ist.</translation>
    </message>
    <message>
        <source>looking</source>
        <translation>wird gesucht</translation>
    </message>
    <message>
        <source>Your changes last until you sign out</source>
        <translation>Ihre Änderungen gelten bis zur Abmeldung</translation>
    </message>
    <message>
        <source>The device holds until Cusp is closed.</source>
        <translation>Das Gerät gilt, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know the device.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start das Gerät nicht.</translation>
    </message>
    <message>
        <source>The file is sound and will be used until Cusp is closed.</source>
        <translation>Die Datei ist in Ordnung und wird verwendet, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know the file.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start die Datei nicht.</translation>
    </message>
    <message>
        <source>Staff choose the device.</source>
        <translation>Das Personal wählt das Gerät.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DrillBar</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>%1, may be delayed</source>
        <translation>%1, evtl. verzögert</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DrillScreen</name>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Getting the tooth ready</source>
        <translation>Der Zahn wird vorbereitet</translation>
    </message>
    <message>
        <source>Finish and see the result?</source>
        <translation>Beenden und das Ergebnis sehen?</translation>
    </message>
    <message>
        <source>The tooth is measured as it is now.</source>
        <translation>Der Zahn wird vermessen, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>Measuring the tooth</source>
        <translation>Der Zahn wird vermessen</translation>
    </message>
    <message>
        <source>Leaving the attempt</source>
        <translation>Der Versuch wird verlassen</translation>
    </message>
    <message>
        <source>Nothing of it is kept.</source>
        <translation>Nichts davon wird aufbewahrt.</translation>
    </message>
    <message>
        <source>It stays in your results as interrupted.</source>
        <translation>Er bleibt als unterbrochen in Ihren Ergebnissen.</translation>
    </message>
    <message>
        <source>It stays in your results as interrupted, without what cannot be written.</source>
        <translation>Er bleibt als unterbrochen in Ihren Ergebnissen, ohne das, was sich nicht schreiben lässt.</translation>
    </message>
    <message>
        <source>Leave this attempt?</source>
        <translation>Diesen Versuch verlassen?</translation>
    </message>
    <message>
        <source>Hand in?</source>
        <translation>Abgeben?</translation>
    </message>
    <message>
        <source>The tooth is kept as it is now; nothing can be changed afterwards.</source>
        <translation>Der Zahn bleibt, wie er jetzt ist; danach lässt sich nichts mehr ändern.</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Starting the attempt</source>
        <translation>Versuch wird gestartet</translation>
    </message>
    <message>
        <source>Fetching the tooth</source>
        <translation>Zahn wird geladen</translation>
    </message>
    <message>
        <source>Growing the tooth: %1</source>
        <translation>Zahn wird erzeugt: %1</translation>
    </message>
    <message>
        <source>Shaping the tooth’s surface</source>
        <translation>Oberfläche des Zahns wird geformt</translation>
    </message>
    <message>
        <source>Growing the other teeth of the jaw</source>
        <translation>Die übrigen Zähne des Kiefers werden erzeugt</translation>
    </message>
    <message>
        <source>Leave this assessment?</source>
        <translation>Diese Prüfung verlassen?</translation>
    </message>
    <message>
        <source>It counts as interrupted. To leave, the invigilator types the start code.</source>
        <translation>Sie zählt als unterbrochen. Zum Verlassen gibt die Aufsicht den Startcode ein.</translation>
    </message>
    <message>
        <source>It stays in your results as interrupted, with what was recorded until the driver of the device stood still.</source>
        <translation>Er bleibt als unterbrochen in Ihren Ergebnissen, mit dem, was bis zum Stillstand des Gerätetreibers aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>The time is over. Measuring the tooth</source>
        <translation>Die Zeit ist um. Der Zahn wird vermessen</translation>
    </message>
    <message>
        <source>An attempt is running</source>
        <translation>Ein Versuch läuft</translation>
    </message>
    <message>
        <source>Cusp closes once the tooth is measured</source>
        <translation>Cusp schließt nach der Vermessung</translation>
    </message>
</context>
<context>
    <name>cusp::ui::DrillStage</name>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Cutaway</source>
        <translation>Aufgeschnitten</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Coach</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Wheel: %1</source>
        <translation>Rad: %1</translation>
    </message>
    <message>
        <source>Hold the left button on the target to drill</source>
        <translation>Zum Bohren die linke Maustaste auf dem Ziel halten</translation>
    </message>
    <message>
        <source>Touch the target and hold the button to drill</source>
        <translation>Das Ziel berühren und zum Bohren die Taste halten</translation>
    </message>
    <message>
        <source>The pulp is open</source>
        <translation>Die Pulpa ist eröffnet</translation>
    </message>
    <message>
        <source>Only %1 left over the pulp</source>
        <translation>Nur noch %1 über der Pulpa</translation>
    </message>
    <message>
        <source>%1 too deep here</source>
        <translation>Hier %1 zu tief</translation>
    </message>
    <message>
        <source>Back inside the line: %1 outside</source>
        <translation>%1 außerhalb der Linie: zurück nach innen</translation>
    </message>
    <message>
        <source>%1 deeper</source>
        <translation>Noch %1 tiefer</translation>
    </message>
    <message>
        <source>Deep enough, move sideways</source>
        <translation>Tief genug, jetzt seitwärts</translation>
    </message>
    <message>
        <source>Nearly all is out: smooth it, then finish</source>
        <translation>Fast alles ist heraus: glätten, dann beenden</translation>
    </message>
    <message>
        <source>Continue where the target remains</source>
        <translation>Weiterarbeiten, wo vom Ziel noch etwas übrig ist</translation>
    </message>
    <message>
        <source>Tolerance zone</source>
        <translation>Toleranzzone</translation>
    </message>
    <message>
        <source>Hold depth</source>
        <translation>Tiefe halten</translation>
    </message>
    <message>
        <source>The bur goes no deeper than now (%1)</source>
        <translation>Der Bohrer geht nicht tiefer als jetzt (%1)</translation>
    </message>
    <message>
        <source>Depth held</source>
        <translation>Tiefe gehalten</translation>
    </message>
    <message>
        <source>Depth free</source>
        <translation>Tiefe frei</translation>
    </message>
    <message>
        <source>Slowly: %1 to the floor</source>
        <translation>Langsam: noch %1 bis zum Boden</translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation>Pulpa</translation>
    </message>
    <message>
        <source>Drag the mirror, tilt it with the right button</source>
        <translation>Den Spiegel ziehen, mit der rechten Taste neigen</translation>
    </message>
    <message>
        <source>Mirror (2): drag it, tilt it with the right button, or I J K L; Shift tilts, U and O bring it nearer and away</source>
        <translation>Spiegel (2): ziehen, mit der rechten Taste neigen, oder I J K L; Umschalt neigt, U und O holen ihn näher und weiter weg</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force %1.</source>
        <translation>Kraft %1.</translation>
    </message>
    <message>
        <source>Depth %1, force %2.</source>
        <translation>Tiefe %1, Kraft %2.</translation>
    </message>
    <message>
        <source>Depth %1, force %2, %3 of the target removed. %4</source>
        <translation>Tiefe %1, Kraft %2, %3 des Ziels abgetragen. %4</translation>
    </message>
    <message>
        <source>Release button or pedal, then press again</source>
        <translation>Taste oder Pedal loslassen, dann erneut drücken</translation>
    </message>
</context>
<context>
    <name>cusp::ui::EditorModel</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove a point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Add a branch</source>
        <translation>Ast hinzufügen</translation>
    </message>
    <message>
        <source>Add a criterion</source>
        <translation>Kriterium hinzufügen</translation>
    </message>
    <message>
        <source>Remove a criterion</source>
        <translation>Kriterium entfernen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Add a bur</source>
        <translation>Bohrer hinzufügen</translation>
    </message>
    <message>
        <source>Remove a bur</source>
        <translation>Bohrer entfernen</translation>
    </message>
    <message>
        <source>Bur</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>The other window’s draft</source>
        <translation>Der Entwurf des anderen Fensters</translation>
    </message>
    <message>
        <source>Tolerance zone</source>
        <translation>Toleranzzone</translation>
    </message>
    <message>
        <source>What fails the attempt</source>
        <translation>Was zum Nichtbestehen führt</translation>
    </message>
    <message>
        <source>Add a shape</source>
        <translation>Form hinzufügen</translation>
    </message>
    <message>
        <source>Remove a shape</source>
        <translation>Form entfernen</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>Expected time</source>
        <translation>Erwartete Zeit</translation>
    </message>
    <message>
        <source>Own assessment</source>
        <translation>Selbsteinschätzung</translation>
    </message>
    <message>
        <source>Propose landmarks</source>
        <translation>Landmarken vorschlagen</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Accept a landmark</source>
        <translation>Landmarke übernehmen</translation>
    </message>
    <message>
        <source>Accept the landmarks</source>
        <translation>Landmarken übernehmen</translation>
    </message>
    <message>
        <source>Remove a landmark</source>
        <translation>Landmarke entfernen</translation>
    </message>
    <message>
        <source>Remove a language</source>
        <translation>Eine Sprache entfernen</translation>
    </message>
    <message>
        <source>Name of a target</source>
        <translation>Name eines Ziels</translation>
    </message>
    <message>
        <source>Tilt of the handpiece</source>
        <translation>Neigung des Handstücks</translation>
    </message>
    <message>
        <source>Turn of the handpiece</source>
        <translation>Drehung des Handstücks</translation>
    </message>
</context>
<context>
    <name>cusp::ui::EditorPage</name>
    <message>
        <source>Editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>The draft is saved.</source>
        <translation>Der Entwurf ist gespeichert.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Keeps the draft and goes back (Alt+Left)</source>
        <translation>Bewahrt den Entwurf auf und geht zurück (Alt+Links)</translation>
    </message>
    <message>
        <source>Title of the exercise</source>
        <translation>Titel der Übung</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Try out</source>
        <translation>Probieren</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>In this exercise</source>
        <translation>In dieser Übung</translation>
    </message>
    <message>
        <source>Put the target on the tooth</source>
        <translation>Ziel auf den Zahn setzen</translation>
    </message>
    <message>
        <source>Moves the target to the middle of the tooth, at its surface</source>
        <translation>Setzt das Ziel in die Mitte des Zahns, an seine Oberfläche</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Change the tooth</source>
        <translation>Zahn ändern</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrollen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Growing the tooth</source>
        <translation>Der Zahn wird erzeugt</translation>
    </message>
    <message>
        <source>No tooth yet</source>
        <translation>Noch kein Zahn</translation>
    </message>
    <message>
        <source>Growing was stopped. The exercise is as it was.</source>
        <translation>Das Erzeugen wurde angehalten. Die Übung ist, wie sie war.</translation>
    </message>
    <message>
        <source>Grow it</source>
        <translation>Erzeugen</translation>
    </message>
    <message>
        <source>Version %1, published</source>
        <translation>Version %1, veröffentlicht</translation>
    </message>
    <message>
        <source>Version %1, not published</source>
        <translation>Version %1, nicht veröffentlicht</translation>
    </message>
    <message>
        <source>Publish version %1</source>
        <translation>Version %1 veröffentlichen</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Y)</source>
        <translation>Wiederholen: %1 (Strg+Y)</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>Wiederholen (Strg+Y)</translation>
    </message>
    <message>
        <source>%1, protected</source>
        <translation>%1, geschützt</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) to look at</source>
        <translation>
            <numerusform>%n Hinweis</numerusform>
            <numerusform>%n Hinweise</numerusform>
        </translation>
    </message>
    <message>
        <source>Everything fits</source>
        <translation>Alles passt</translation>
    </message>
    <message>
        <source>publishing waits for it</source>
        <translation>das Veröffentlichen wartet darauf</translation>
    </message>
    <message>
        <source>the tooth is still being checked</source>
        <translation>der Zahn wird noch geprüft</translation>
    </message>
    <message>
        <source>nothing was changed since it was published</source>
        <translation>seit der Veröffentlichung wurde nichts geändert</translation>
    </message>
    <message>
        <source>ready to publish</source>
        <translation>bereit zum Veröffentlichen</translation>
    </message>
    <message>
        <source>Check fails</source>
        <translation>Kontrolle misslingt</translation>
    </message>
    <message>
        <source>Checks passed</source>
        <translation>Kontrollen bestanden</translation>
    </message>
    <message>
        <source>Version %1 is published.</source>
        <translation>Version %1 ist veröffentlicht.</translation>
    </message>
    <message>
        <source>Students find it among their exercises. Earlier results keep the version they were made with.</source>
        <translation>Studierende finden sie unter ihren Übungen. Frühere Ergebnisse behalten die Version, mit der sie entstanden.</translation>
    </message>
    <message>
        <source>Tissues</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Aufwand</translation>
    </message>
    <message>
        <source>Keep mine as a copy</source>
        <translation>Meinen als Kopie behalten</translation>
    </message>
    <message>
        <source>See theirs</source>
        <translation>Den anderen ansehen</translation>
    </message>
    <message>
        <source>Replace theirs</source>
        <translation>Den anderen ersetzen</translation>
    </message>
    <message>
        <source>Another window saved this draft: %1.</source>
        <translation>Ein anderes Fenster hat diesen Entwurf gespeichert: %1.</translation>
    </message>
    <message>
        <source>Yours is not saved. Nothing is replaced until you choose.</source>
        <translation>Ihrer ist nicht gespeichert. Nichts wird ersetzt, bis Sie wählen.</translation>
    </message>
    <message>
        <source>Another window published or discarded this draft.</source>
        <translation>Ein anderes Fenster hat diesen Entwurf veröffentlicht oder verworfen.</translation>
    </message>
    <message>
        <source>The other window’s draft cannot be read.</source>
        <translation>Der Entwurf des anderen Fensters lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>Yours stands as it was.</source>
        <translation>Ihrer ist unverändert.</translation>
    </message>
    <message>
        <source>This is the other window’s draft.</source>
        <translation>Das ist der Entwurf des anderen Fensters.</translation>
    </message>
    <message>
        <source>Undo brings yours back.</source>
        <translation>Rückgängig bringt Ihren zurück.</translation>
    </message>
    <message>
        <source>Replace the other window’s draft?</source>
        <translation>Den Entwurf des anderen Fensters ersetzen?</translation>
    </message>
    <message>
        <source>What was changed there is lost.</source>
        <translation>Was dort geändert wurde, geht verloren.</translation>
    </message>
    <message>
        <source>Title, in the language of the screen; the others stand under Texts</source>
        <translation>Titel in der Sprache der Oberfläche; die anderen stehen unter Texte</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Choose an outline among the parts of the target first</source>
        <translation>Zuerst unter den Formen des Ziels einen Umriss wählen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Try out by the reference operator</source>
        <translation>Vom Referenzoperateur probieren lassen</translation>
    </message>
    <message>
        <source>The reference operator cuts it at once, and a report shows its points (Shift+F5)</source>
        <translation>Der Referenzoperateur präpariert die Übung sofort; ein Bericht zeigt seine Punkte (Umschalt+F5)</translation>
    </message>
    <message>
        <source>The reference operator cuts it</source>
        <translation>Der Referenzoperateur präpariert</translation>
    </message>
    <message>
        <source>Publishing…</source>
        <translation>Wird veröffentlicht …</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Stop checking</source>
        <translation>Kontrolle abbrechen</translation>
    </message>
    <message>
        <source>Leave without the briefing?</source>
        <translation>Den Editor ohne die Aufgabe verlassen?</translation>
    </message>
    <message>
        <source>The exercise keeps the briefing as it was. Under Texts stands why.</source>
        <translation>Die Übung behält die Aufgabe, wie sie war. Unter „Texte“ steht, warum.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>The draft is saved without the briefing.</source>
        <translation>Der Entwurf ist ohne die Aufgabe gespeichert.</translation>
    </message>
    <message>
        <source>Publish without the briefing?</source>
        <translation>Ohne die Aufgabe veröffentlichen?</translation>
    </message>
    <message>
        <source>%1 of %2 things to look at</source>
        <translation>Hinweis %1 von %2</translation>
    </message>
    <message>
        <source>Next check</source>
        <translation>Nächster Hinweis</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExchangePage</name>
    <message>
        <source>Other stations</source>
        <translation>Andere Stationen</translation>
    </message>
    <message>
        <source>Read a file in</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Whose files are read here</source>
        <translation>Wessen Dateien hier eingelesen werden</translation>
    </message>
    <message>
        <source>Known stations</source>
        <translation>Bekannte Stationen</translation>
    </message>
    <message>
        <source>No other station is known yet</source>
        <translation>Noch ist keine andere Station bekannt</translation>
    </message>
    <message>
        <source>Records go from station to station as files, without a server. A station reads the files of those alone whose keys an administrator has compared and made known.</source>
        <translation>Aufzeichnungen gehen als Dateien von Station zu Station, ohne Server. Eine Station liest nur Dateien von Stationen ein, deren Schlüssel die Verwaltung verglichen und bekannt gemacht hat.</translation>
    </message>
    <message>
        <source>Choose a station’s key</source>
        <translation>Schlüssel einer Station wählen</translation>
    </message>
    <message>
        <source>Make a station known</source>
        <translation>Station bekannt machen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Revoke the key</source>
        <translation>Schlüssel widerrufen</translation>
    </message>
    <message>
        <source>This station</source>
        <translation>Diese Station</translation>
    </message>
    <message>
        <source>Clinic, room 1</source>
        <translation>Klinik, Raum 1</translation>
    </message>
    <message>
        <source>What you call it; files are named after it</source>
        <translation>Name der Station; Dateien heißen danach</translation>
    </message>
    <message>
        <source>The records were opened for reading: their key is not there.</source>
        <translation>Die Aufzeichnungen wurden nur zum Lesen geöffnet: Ihr Schlüssel ist nicht da.</translation>
    </message>
    <message>
        <source>Fingerprint of its key, to be read aloud and compared at the other station</source>
        <translation>Fingerabdruck ihres Schlüssels, zum Vorlesen und Vergleichen an der anderen Station</translation>
    </message>
    <message>
        <source>Fingerprint %1</source>
        <translation>Fingerabdruck %1</translation>
    </message>
    <message>
        <source>Save the key as a file</source>
        <translation>Schlüssel speichern</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the fingerprint</source>
        <translation>Fingerabdruck kopieren</translation>
    </message>
    <message>
        <source>Give out a file</source>
        <translation>Datei herausgeben</translation>
    </message>
    <message>
        <source>Results for the office</source>
        <translation>Ergebnisse für die Zentrale</translation>
    </message>
    <message>
        <source>People and assignments</source>
        <translation>Personen und Zuweisungen</translation>
    </message>
    <message>
        <source>Every ended attempt of this station, its grades and what examiners said.</source>
        <translation>Jeder beendete Versuch dieser Station mit Bewertungen und Erklärungen der Lehrkräfte.</translation>
    </message>
    <message>
        <source>From the office to the stations: people, cohorts, assignments and exercises. It holds passwords and PINs in scrambled form: keep it as safe as the records.</source>
        <translation>Von der Zentrale an die Stationen: Personen, Kohorten, Zuweisungen und Übungen. Die Datei enthält Passwörter und PINs in unkenntlicher Form: Verwahren Sie sie so sicher wie die Aufzeichnungen.</translation>
    </message>
    <message>
        <source>The other stations cannot be listed.</source>
        <translation>Die anderen Stationen lassen sich nicht auflisten.</translation>
    </message>
    <message>
        <source>Save this station’s key</source>
        <translation>Schlüssel dieser Station speichern</translation>
    </message>
    <message>
        <source>Key of a station (*.cuspkey)</source>
        <translation>Schlüssel einer Station (*.cuspkey)</translation>
    </message>
    <message>
        <source>The key is saved.</source>
        <translation>Der Schlüssel ist gespeichert.</translation>
    </message>
    <message>
        <source>Take %1 to the other station, and tell its administrator the fingerprint.</source>
        <translation>Bringen Sie %1 zur anderen Station und nennen Sie deren Verwaltung den Fingerabdruck.</translation>
    </message>
    <message>
        <source>The key was not saved.</source>
        <translation>Der Schlüssel wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>The fingerprint is copied.</source>
        <translation>Der Fingerabdruck ist kopiert.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>%1 is known: its files are read from now on.</source>
        <translation>%1 ist bekannt: Dateien von dort werden ab jetzt eingelesen.</translation>
    </message>
    <message>
        <source>Revoke the key of %1?</source>
        <translation>Schlüssel von %1 widerrufen?</translation>
    </message>
    <message>
        <source>Files under key %1 are no longer read. All that was read before stays.</source>
        <translation>Dateien unter dem Schlüssel %1 werden nicht mehr eingelesen. Was schon eingelesen ist, bleibt.</translation>
    </message>
    <message>
        <source>The key of %1 is revoked.</source>
        <translation>Der Schlüssel von %1 ist widerrufen.</translation>
    </message>
    <message>
        <source>All that was read before stays.</source>
        <translation>Was schon eingelesen ist, bleibt.</translation>
    </message>
    <message>
        <source>Give out people and assignments</source>
        <translation>Personen und Zuweisungen herausgeben</translation>
    </message>
    <message>
        <source>Give out results</source>
        <translation>Ergebnisse herausgeben</translation>
    </message>
    <message>
        <source>File of a station (*.cuspexchange)</source>
        <translation>Datei einer Station (*.cuspexchange)</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>Die Datei wird geschrieben</translation>
    </message>
    <message>
        <source>No file was given out.</source>
        <translation>Es wurde keine Datei herausgegeben.</translation>
    </message>
    <message>
        <source>File %1 of this station is written: %2.</source>
        <translation>Datei %1 dieser Station ist geschrieben: %2.</translation>
    </message>
    <message>
        <source>%1. Read it in at each station.</source>
        <translation>%1. Lesen Sie sie an jeder Station ein.</translation>
    </message>
    <message>
        <source>%1. Read it in at the office.</source>
        <translation>%1. Lesen Sie sie in der Zentrale ein.</translation>
    </message>
    <message>
        <source>Choose a file of another station</source>
        <translation>Datei einer anderen Station wählen</translation>
    </message>
    <message>
        <source>Checking the file</source>
        <translation>Die Datei wird geprüft</translation>
    </message>
    <message>
        <source>This station is not known as the office here.</source>
        <translation>Diese Station ist hier nicht als Zentrale bekannt.</translation>
    </message>
    <message>
        <source>Only the office’s files bring people and assignments. Make it known as the office, or go back. Nothing was changed.</source>
        <translation>Nur Dateien der Zentrale bringen Personen und Zuweisungen. Machen Sie sie als Zentrale bekannt oder gehen Sie zurück. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The file is of a station that is not known here.</source>
        <translation>Die Datei stammt von einer hier unbekannten Station.</translation>
    </message>
    <message>
        <source>Compare the fingerprint before you make it known. Nothing was changed.</source>
        <translation>Vergleichen Sie den Fingerabdruck, bevor Sie sie bekannt machen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Reading the file in</source>
        <translation>Die Datei wird eingelesen</translation>
    </message>
    <message>
        <source>For what has changed since, ask that station for a new file.</source>
        <translation>Für spätere Änderungen bitten Sie jene Station um eine neue Datei.</translation>
    </message>
    <message>
        <source>The key of %1 was changed in another window meanwhile.</source>
        <translation>Der Schlüssel von %1 wurde inzwischen in einem anderen Fenster geändert.</translation>
    </message>
    <message>
        <source>The list shows it as it is now. Nothing was changed here.</source>
        <translation>Die Liste zeigt ihn, wie er jetzt ist. Hier wurde nichts geändert.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know the name.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start den Namen nicht.</translation>
    </message>
    <message>
        <source>The name holds until Cusp is closed.</source>
        <translation>Der Name gilt, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>You stopped it. Nothing was changed.</source>
        <translation>Sie haben abgebrochen. Es wurde nichts verändert.</translation>
    </message>
    <message>
        <source>Copied %1 of %2 people</source>
        <translation>%1 von %2 Personen kopiert</translation>
    </message>
    <message>
        <source>Copied %1 of %2 attempts</source>
        <translation>%1 von %2 Versuchen kopiert</translation>
    </message>
    <message>
        <source>Checked %1 of %2</source>
        <translation>%1 von %2 geprüft</translation>
    </message>
    <message>
        <source>The file was not checked.</source>
        <translation>Die Datei wurde nicht geprüft.</translation>
    </message>
    <message>
        <source>Read %1 of %2 people</source>
        <translation>%1 von %2 Personen eingelesen</translation>
    </message>
    <message>
        <source>Read %1 of %2 attempts</source>
        <translation>%1 von %2 Versuchen eingelesen</translation>
    </message>
    <message>
        <source>The file was not read.</source>
        <translation>Die Datei wurde nicht eingelesen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExerciseCard</name>
    <message>
        <source>The chosen exercise</source>
        <translation>Die gewählte Übung</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Burs: %1</source>
        <translation>Bohrer: %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExerciseUse</name>
    <message>
        <source>No student has a graded attempt yet.</source>
        <translation>Noch kein bewerteter Versuch von Studierenden.</translation>
    </message>
    <message>
        <source>%1, %2, median %3 points.</source>
        <extracomment>%1: &quot;12 students&quot;, %2: &quot;40 graded attempts&quot;, %3: points, of 100</extracomment>
        <translation>%1, %2, Median %3 Punkte.</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n Student/in</numerusform>
            <numerusform>%n Studierende</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n graded attempt(s)</source>
        <translation>
            <numerusform>%n bewerteter Versuch</numerusform>
            <numerusform>%n bewertete Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Assigned now: %1.</source>
        <translation>Jetzt zugewiesen: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
</context>
<context>
    <name>cusp::ui::ExercisesPage</name>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Enter opens the briefing</source>
        <translation>Enter öffnet die Aufgabe</translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s) cannot be read.</source>
        <translation>
            <numerusform>%n Übung kann nicht gelesen werden.</numerusform>
            <numerusform>%n Übungen können nicht gelesen werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>No exercise fits</source>
        <translation>Keine Übung passt</translation>
    </message>
    <message>
        <source>Show all exercises</source>
        <translation>Alle Übungen zeigen</translation>
    </message>
    <message>
        <source>Find an exercise</source>
        <translation>Übung finden</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Noch nicht bestanden</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>No exercise of this standing has this text in its name.</source>
        <translation>Keine Übung mit diesem Ergebnis hat diesen Text im Namen.</translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 von %2 bestanden</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>An instructor publishes them again from the editor. All others are below.</source>
        <translation>Eine Lehrkraft veröffentlicht sie im Editor erneut. Alle anderen stehen unten.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Falcon</name>
    <message>
        <source>Looking for it</source>
        <translation>Wird gesucht</translation>
    </message>
    <message>
        <source>Asking whether its firmware runs</source>
        <translation>Läuft seine Firmware schon?</translation>
    </message>
    <message>
        <source>It needs its firmware file</source>
        <translation>Er braucht seine Firmware-Datei</translation>
    </message>
    <message>
        <source>Waking its loader</source>
        <translation>Sein Lader wird geweckt</translation>
    </message>
    <message>
        <source>Loading its firmware, %1</source>
        <translation>Seine Firmware wird geladen, %1</translation>
    </message>
    <message>
        <source>Finding its middle</source>
        <translation>Er sucht seine Mitte</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>No answer, force off</source>
        <translation>Keine Antwort, Kraft aus</translation>
    </message>
    <message>
        <source>Ten attempts failed; it is tried again</source>
        <translation>Zehn Versuche misslangen; es geht weiter</translation>
    </message>
    <message>
        <source>All three arms know their place.</source>
        <translation>Alle drei Arme kennen ihren Ort.</translation>
    </message>
    <message>
        <source>Pull the grip all the way out, then push it all the way in. Do it slowly, until all three arms are filled.</source>
        <translation>Den Griff ganz herausziehen, dann ganz hineinschieben. Langsam, bis alle drei Arme gefüllt sind.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware file.</source>
        <translation>Der Falcon braucht seine Firmware-Datei.</translation>
    </message>
    <message>
        <source>Staff can name the file on the Device page, under Firmware.</source>
        <translation>Das Personal nennt die Datei auf der Seite Gerät unter Firmware.</translation>
    </message>
    <message>
        <source>The firmware file is not the one that was named.</source>
        <translation>Die Firmware-Datei ist nicht mehr die genannte.</translation>
    </message>
    <message>
        <source>%1 has changed since. Name it again if that was meant.</source>
        <translation>%1 hat sich seitdem geändert. War das gewollt, nennen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The firmware file cannot be used.</source>
        <translation>Die Firmware-Datei ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Look at %1, or name another one.</source>
        <translation>Sehen Sie bei %1 nach, oder nennen Sie eine andere.</translation>
    </message>
    <message>
        <source>The Falcon is plugged in and does not answer.</source>
        <translation>Der Falcon ist angeschlossen und antwortet nicht.</translation>
    </message>
    <message>
        <source>Most often its power adapter is off. Plug the adapter in, then try again.</source>
        <translation>Meist hat sein Netzteil keinen Strom. Netzteil einstecken, dann noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon did not start.</source>
        <translation>Der Falcon lief nicht an.</translation>
    </message>
    <message>
        <source>Pull its power plug, wait five seconds, put it in, and try again. (%1)</source>
        <translation>Netzstecker ziehen, fünf Sekunden warten, einstecken, noch einmal. (%1)</translation>
    </message>
    <message>
        <source>This is no firmware of a Falcon.</source>
        <translation>Das ist keine Firmware eines Falcon.</translation>
    </message>
    <message>
        <source>The file that was named before is kept.</source>
        <translation>Die vorher genannte Datei bleibt.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei ist nicht lesbar.</translation>
    </message>
    <message>
        <source>It is too small.</source>
        <translation>Sie ist zu klein.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Sie ist zu groß.</translation>
    </message>
    <message>
        <source>It breaks off.</source>
        <translation>Sie bricht ab.</translation>
    </message>
    <message>
        <source>It is built in another way.</source>
        <translation>Sie ist anders aufgebaut.</translation>
    </message>
    <message>
        <source>Stopped. Nothing was changed.</source>
        <translation>Angehalten. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The Falcon stopped answering. Nothing was changed.</source>
        <translation>Der Falcon antwortete nicht mehr. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The grip moved too fast, so the force was switched off. Nothing was changed.</source>
        <translation>Der Griff bewegte sich zu schnell; die Kraft wurde abgeschaltet. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The grip was held, or came to the end of its travel. Nothing was changed.</source>
        <translation>Der Griff wurde festgehalten oder kam ans Ende seines Weges. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Emulated Falcon, driven by mouse</source>
        <translation>Nachgebildeter Falcon, mit der Maus geführt</translation>
    </message>
    <message>
        <source>It pushes to the right</source>
        <translation>Er drückt nach rechts</translation>
    </message>
    <message>
        <source>It pushes to the left</source>
        <translation>Er drückt nach links</translation>
    </message>
    <message>
        <source>It pushes up</source>
        <translation>Er drückt nach oben</translation>
    </message>
    <message>
        <source>It pushes down</source>
        <translation>Er drückt nach unten</translation>
    </message>
    <message>
        <source>It pushes towards you</source>
        <translation>Er drückt zu Ihnen hin</translation>
    </message>
    <message>
        <source>It pushes away from you</source>
        <translation>Er drückt von Ihnen weg</translation>
    </message>
    <message>
        <source>Damping %1, friction %2, delay %3, step %4. Exercises may be as stiff as %5 (before: %6).</source>
        <translation>Dämpfung %1, Reibung %2, Verzug %3, Schritt %4. Übungen dürfen bis %5 steif sein (vorher: %6).</translation>
    </message>
    <message>
        <source>This user may not open it</source>
        <translation>Dieses Benutzerkonto darf es nicht öffnen</translation>
    </message>
    <message>
        <source>Another program holds it</source>
        <translation>Ein anderes Programm hält es</translation>
    </message>
    <message>
        <source>The Device page shows the line that permits it.</source>
        <translation>Die Seite Gerät zeigt die Zeile, die es erlaubt.</translation>
    </message>
    <message>
        <source>Close the other program. The Falcon is then found by itself.</source>
        <translation>Schließen Sie das andere Programm. Der Falcon wird dann von selbst gefunden.</translation>
    </message>
    <message>
        <source>Most often its power adapter is off. Plug the adapter in.</source>
        <translation>Meist ist sein Netzteil aus. Stecken Sie das Netzteil ein.</translation>
    </message>
    <message>
        <source>Pull its power plug, wait five seconds, and put it in.</source>
        <translation>Ziehen Sie seinen Netzstecker, warten Sie fünf Sekunden und stecken Sie ihn wieder ein.</translation>
    </message>
    <message>
        <source>The Falcon answers too late.</source>
        <translation>Der Falcon antwortet zu spät.</translation>
    </message>
    <message>
        <source>Plug it into another USB socket of this computer, without a hub, then try again.</source>
        <translation>Stecken Sie ihn ohne Hub in eine andere USB-Buchse dieses Computers und versuchen Sie es dann noch einmal.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::FalconNow</name>
    <message>
        <source>Answers a second</source>
        <translation>Antworten je Sekunde</translation>
    </message>
    <message>
        <source>Late: half of them, one in a hundred, the latest</source>
        <translation>Verspätet: die Hälfte, eine von hundert, die späteste</translation>
    </message>
    <message>
        <source>Silences and lost answers</source>
        <translation>Aussetzer und verlorene Antworten</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Vorrang</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Before everything else</source>
        <translation>Vor allem anderen</translation>
    </message>
    <message>
        <source>As any program: others may delay it</source>
        <translation>Wie jedes Programm: Andere können es aufhalten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
</context>
<context>
    <name>cusp::ui::FalconPanel</name>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Mitte finden</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>Feel the force</source>
        <translation>Kraft fühlen</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Weigh the grip</source>
        <translation>Griff wiegen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Bericht speichern …</translation>
    </message>
    <message>
        <source>Measuring, direction %1 of 3. Keep your hand off.</source>
        <translation>Richtung %1 von 3 wird gemessen. Bitte nicht berühren.</translation>
    </message>
    <message>
        <source>Weighing, place %1 of %2. Keep your hand off.</source>
        <translation>Der Griff wird gewogen, Ort %1 von %2. Bitte nicht berühren.</translation>
    </message>
    <message>
        <source>Hold the grip loosely</source>
        <translation>Den Griff locker halten</translation>
    </message>
    <message>
        <source>It pushes six ways, one after the other, up to %1. Releasing the grip switches it off.</source>
        <translation>Er drückt nacheinander in sechs Richtungen, bis zu %1. Loslassen schaltet ab.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Release the grip</source>
        <translation>Den Griff loslassen</translation>
    </message>
    <message>
        <source>For half a minute it moves by itself, a centimetre each way. Nobody may touch it, and nothing may stand in its way.</source>
        <translation>Eine halbe Minute lang bewegt er sich selbst, einen Zentimeter in jede Richtung. Niemand darf ihn berühren, und nichts darf im Weg stehen.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Stand it upright and release the grip</source>
        <translation>Aufrecht hinstellen und den Griff loslassen</translation>
    </message>
    <message>
        <source>It holds the grip at nine places, for half a minute. From then on it carries its own weight.</source>
        <translation>Er hält den Griff an neun Orten, eine halbe Minute lang. Danach trägt er sein Gewicht selbst.</translation>
    </message>
    <message>
        <source>Weigh</source>
        <translation>Wiegen</translation>
    </message>
    <message>
        <source>All six ways were pushed. If one of them felt wrong, report it to the staff.</source>
        <translation>In alle sechs Richtungen wurde gedrückt. Fühlte sich eine falsch an, melden Sie es dem Personal.</translation>
    </message>
    <message>
        <source>No weight fits what was held. Stand it upright, keep hands off, and weigh again.</source>
        <translation>Kein Gewicht passt zu dem, was gehalten wurde. Stellen Sie das Gerät aufrecht hin, berühren Sie es nicht und wiegen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The grip weighs %1. Nothing is kept of an emulated one.</source>
        <translation>Der Griff wiegt %1. Von einem nachgebildeten wird nichts aufbewahrt.</translation>
    </message>
    <message>
        <source>It moved too little to be measured. Is something in its way? The report has what there is.</source>
        <translation>Er bewegte sich zu wenig, um ihn zu messen. Ist etwas im Weg? Im Bericht steht, was da ist.</translation>
    </message>
    <message>
        <source>Not measured yet: damping and delay are assumed, and exercises are no stiffer than %1.</source>
        <translation>Noch nicht gemessen: Dämpfung und Verzug sind angenommen, und Übungen sind höchstens %1 steif.</translation>
    </message>
    <message>
        <source>Measured %1: exercises are no stiffer than %2.</source>
        <translation>Gemessen %1: Übungen sind höchstens %2 steif.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Report (*.json)</source>
        <translation>Bericht (*.json)</translation>
    </message>
    <message>
        <source>The report lies at %1.</source>
        <translation>Der Bericht liegt unter %1.</translation>
    </message>
    <message>
        <source>How the grip leads the bur</source>
        <translation>Wie der Griff den Bohrer führt</translation>
    </message>
    <message>
        <source>The grip weighs %1. From the next attempt on it carries itself.</source>
        <translation>Der Griff wiegt %1. Vom nächsten Versuch an trägt er sich selbst.</translation>
    </message>
    <message>
        <source>The figures of an emulated one are not kept.</source>
        <translation>Die Werte eines nachgebildeten werden nicht übernommen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::FileCard</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>What is in the file</source>
        <translation>Inhalt der Datei</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translation>%1, Schlüssel %2</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>%1, file %2 of this station</source>
        <translation>%1, Datei %2 dieser Station</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Read it in</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>File %1 of this station was read in already, and this one is older: it adds what is new and changes nothing. For what has changed since, ask for a new file.</source>
        <translation>Datei %1 dieser Station ist schon eingelesen, und diese ist älter: Sie ergänzt Neues und ändert nichts. Für spätere Änderungen bitten Sie um eine neue Datei.</translation>
    </message>
    <message>
        <source>This file was read in already. Read again, it adds only what still waited for another file.</source>
        <translation>Diese Datei ist schon eingelesen. Erneut eingelesen ergänzt sie nur, was noch auf eine andere Datei wartete.</translation>
    </message>
    <message>
        <source>Accounts that the office has changed take the place of those here. Nothing is changed until you read it in; it is read whole or not at all.</source>
        <translation>Konten, die die Zentrale geändert hat, ersetzen die hiesigen. Bis Sie die Datei einlesen, ändert sich nichts; sie wird ganz eingelesen oder gar nicht.</translation>
    </message>
    <message>
        <source>It adds what is not here yet. Nothing is changed until you read it in; it is read whole or not at all.</source>
        <translation>Sie ergänzt, was hier noch fehlt. Bis Sie die Datei einlesen, ändert sich nichts; sie wird ganz eingelesen oder gar nicht.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::HalfFilled</name>
    <message>
        <source>Leave without saving the form?</source>
        <translation>Die Seite verlassen, ohne das Formular zu speichern?</translation>
    </message>
    <message>
        <source>What was filled in and not saved is not kept.</source>
        <translation>Was ausgefüllt und nicht gespeichert ist, bleibt nicht erhalten.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::HandedIn</name>
    <message>
        <source>Handed in</source>
        <translation>Abgegeben</translation>
    </message>
    <message>
        <source>The preparation of candidate %1 is kept. The result is shown when your examiner releases it.</source>
        <translation>Die Präparation von Kandidat/in %1 ist aufbewahrt. Das Ergebnis erscheint, wenn es freigegeben wird.</translation>
    </message>
    <message>
        <source>Next candidate</source>
        <translation>Nächste/r Kandidat/in</translation>
    </message>
    <message>
        <source>To the start page</source>
        <translation>Zur Startseite</translation>
    </message>
</context>
<context>
    <name>cusp::ui::HandpiecePanel</name>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Tooth warmer by</source>
        <translation>Zahn wärmer um</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Ton aus</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton ein</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>No sound: this computer has no audio output.</source>
        <translation>Kein Ton: Dieser Rechner hat keine Tonausgabe.</translation>
    </message>
    <message>
        <source>Coolant is on</source>
        <translation>Kühlung ist ein</translation>
    </message>
    <message>
        <source>Coolant is off</source>
        <translation>Kühlung ist aus</translation>
    </message>
    <message>
        <source>Turn the coolant off</source>
        <translation>Kühlung ausschalten</translation>
    </message>
    <message>
        <source>Turn the coolant on</source>
        <translation>Kühlung einschalten</translation>
    </message>
    <message>
        <source>stalled, push less</source>
        <extracomment>Turns of the bur in a minute.</extracomment>
        <translation>steht, weniger Druck</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation>%1 U/min</translation>
    </message>
    <message>
        <source>Speed %1.</source>
        <translation>Drehzahl %1.</translation>
    </message>
    <message>
        <source>Tooth warmer by %1.</source>
        <translation>Zahn wärmer um %1.</translation>
    </message>
    <message>
        <source>The pulp is at risk from a rise of %1</source>
        <translation>Gefahr für die Pulpa ab einem Anstieg von %1</translation>
    </message>
    <message>
        <source>Too warm for the pulp (a rise of %1): run the coolant</source>
        <translation>Zu warm für die Pulpa (Anstieg von %1): kühlen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>1. Choose an exercise and read its briefing: what to remove, how deep, and what earns points.</source>
        <translation>1. Übung wählen und die Aufgabe lesen: was abzutragen ist, wie tief, und was Punkte bringt.</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>Tasten überall</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>diese Seite</translation>
    </message>
    <message>
        <source>next pane</source>
        <translation>nächster Bereich</translation>
    </message>
    <message>
        <source>go to any page or exercise</source>
        <translation>zu jeder Seite oder Übung gehen</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>out of what is open</source>
        <translation>Geöffnetes schließen</translation>
    </message>
    <message>
        <source>a chart as its table, and back</source>
        <translation>ein Diagramm als Tabelle, und zurück</translation>
    </message>
    <message>
        <source>opens the chosen row</source>
        <translation>öffnet die gewählte Zeile</translation>
    </message>
    <message>
        <source>Keys while drilling</source>
        <translation>Tasten beim Bohren</translation>
    </message>
    <message>
        <source>slide the bur</source>
        <translation>den Bohrer führen</translation>
    </message>
    <message>
        <source>push less, push more</source>
        <translation>weniger drücken, mehr drücken</translation>
    </message>
    <message>
        <source>turn the handpiece, where the exercise lets it; Home: back</source>
        <translation>das Handstück drehen, wo die Übung es erlaubt; Pos1: zurück</translation>
    </message>
    <message>
        <source>cut while held</source>
        <translation>trägt ab, solange gehalten</translation>
    </message>
    <message>
        <source>previous bur, next bur</source>
        <translation>voriger Bohrer, nächster Bohrer</translation>
    </message>
    <message>
        <source>pause and resume</source>
        <translation>anhalten und fortsetzen</translation>
    </message>
    <message>
        <source>finish (asks)</source>
        <translation>beenden (fragt nach)</translation>
    </message>
    <message>
        <source>How it is marked</source>
        <translation>Wie bewertet wird</translation>
    </message>
    <message>
        <source>± shows how well a figure is known. If an edge of the marking is nearer than that, the report shows it.</source>
        <translation>± zeigt, wie genau ein Wert bekannt ist. Liegt eine Grenze der Bewertung näher, so zeigt es der Bericht.</translation>
    </message>
    <message>
        <source>coolant on and off, where the exercise has it</source>
        <translation>Kühlung ein und aus, wo die Übung sie hat</translation>
    </message>
    <message>
        <source>drilling sound on and off, likewise</source>
        <translation>Bohrgeräusch ein und aus, wo die Übung es hat</translation>
    </message>
    <message>
        <source>An attempt, from start to report</source>
        <translation>Ein Versuch, vom Start bis zum Bericht</translation>
    </message>
    <message>
        <source>3. Hold Space or the left button to cut. The target is the solid line, the tolerance zone round it the dashed one.</source>
        <translation>3. Zum Abtragen die Leertaste oder die linke Maustaste halten. Die durchgezogene Linie ist das Ziel, die gestrichelte darum die Toleranzzone.</translation>
    </message>
    <message>
        <source>4. Finish ends the attempt and grades it. The report shows what was measured, how well it is known, and what to do next time.</source>
        <translation>4. Beenden schließt den Versuch ab und bewertet ihn. Der Bericht zeigt, was gemessen wurde, wie genau es bekannt ist und was beim nächsten Mal zu tun ist.</translation>
    </message>
    <message>
        <source>5. Every attempt stays under My results. An attempt that broke off is kept up to its last second.</source>
        <translation>5. Jeder Versuch bleibt unter Meine Ergebnisse. Ein unterbrochener Versuch ist bis zur letzten Sekunde erhalten.</translation>
    </message>
    <message>
        <source>Target removed: how much of the required cavity is cut. Not removed: what remains of it.</source>
        <translation>Ziel abgetragen: wie viel der geforderten Kavität abgetragen ist. Nicht entfernt: was davon übrig ist.</translation>
    </message>
    <message>
        <source>Over-cut: what is removed outside the target. Within the tolerance zone it costs little, beyond it much.</source>
        <translation>Überpräpariert: was außerhalb des Ziels abgetragen ist. In der Toleranzzone kostet es wenig, jenseits davon viel.</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>hold the depth, let it go (mouse)</source>
        <translation>Tiefe halten, wieder freigeben (Maus)</translation>
    </message>
    <message>
        <source>move the mirror; with Shift: tilt it; U, O: nearer, away</source>
        <translation>Spiegel bewegen; mit Umschalt: neigen; U, O: näher, weiter weg</translation>
    </message>
    <message>
        <source>Quick start in five pictures</source>
        <translation>Schnellstart in fünf Bildern</translation>
    </message>
    <message>
        <source>views of the tooth, target and handpiece</source>
        <translation>Ansichten des Zahns, Ziel und Handstück</translation>
    </message>
    <message>
        <source>5. Every attempt stays under Performance. An attempt that broke off is kept up to its last second.</source>
        <translation>5. Jeder Versuch bleibt unter Leistungen. Ein unterbrochener Versuch ist bis zur letzten Sekunde erhalten.</translation>
    </message>
    <message>
        <source>Time earns points only in an exercise whose briefing lists it under What earns points.</source>
        <translation>Zeit bringt nur in einer Übung Punkte, deren Aufgabe sie unter Was Punkte bringt aufführt.</translation>
    </message>
    <message>
        <source>2. Slide the bur over the tooth with the mouse or the arrow keys. Push with the wheel or Page Down. The bar at the right shows the force, the bar at the left the depth.</source>
        <translation>2. Den Bohrer mit der Maus oder den Pfeiltasten über den Zahn führen. Mit dem Mausrad oder Bild ab drücken. Der Balken rechts zeigt die Kraft, der Balken links die Tiefe.</translation>
    </message>
    <message>
        <source>find an exercise by its name</source>
        <translation>eine Übung nach ihrem Namen suchen</translation>
    </message>
    <message>
        <source>hide the panel at the right, show it</source>
        <translation>die Leiste rechts ausblenden, einblenden</translation>
    </message>
    <message>
        <source>have the values read aloud (screen reader)</source>
        <translation>die Werte vorlesen lassen (Bildschirmleser)</translation>
    </message>
</context>
<context>
    <name>cusp::ui::HistoryCharts</name>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>Time and score</source>
        <translation>Zeit und Punkte</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points by attempt</source>
        <translation>Punkte je Versuch</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Own assessment</source>
        <translation>Selbsteinschätzung</translation>
    </message>
    <message>
        <source>Own less measured</source>
        <translation>Selbst minus gemessen</translation>
    </message>
    <message>
        <source>%1: own %2, measured %3</source>
        <extracomment>Of an attempt: its date, points by own assessment, measured points.</extracomment>
        <translation>%1: selbst %2, gemessen %3</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>wie gemessen</translation>
    </message>
    <message>
        <source>Attempts: %1. The last has %2 of 100 points.</source>
        <translation>Versuche: %1. Der letzte hat %2 von 100 Punkten.</translation>
    </message>
    <message>
        <source>The best has %1.</source>
        <translation>Der beste hat %1.</translation>
    </message>
    <message>
        <source>The pass mark is %1.</source>
        <translation>Die Bestehensgrenze ist %1.</translation>
    </message>
    <message>
        <source>Rated attempts: %1. The last was rated %2 of 100 points higher than it was measured.</source>
        <translation>Eingeschätzte Versuche: %1. Der letzte wurde um %2 von 100 Punkten höher eingeschätzt, als gemessen wurde.</translation>
    </message>
    <message>
        <source>Rated attempts: %1. The last was rated %2 of 100 points lower than it was measured.</source>
        <translation>Eingeschätzte Versuche: %1. Der letzte wurde um %2 von 100 Punkten niedriger eingeschätzt, als gemessen wurde.</translation>
    </message>
    <message>
        <source>Rated attempts: %1. The last was rated as it was measured.</source>
        <translation>Eingeschätzte Versuche: %1. Der letzte wurde so eingeschätzt, wie gemessen wurde.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportDrop</name>
    <message>
        <source>Drop files here</source>
        <translation>Dateien hierher ziehen</translation>
    </message>
    <message>
        <source>or choose them. Several surfaces are put together, each of one tissue.</source>
        <translation>oder auswählen. Mehrere Oberflächen werden zusammengefügt, jede aus einem Gewebe.</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>From a scanner or a modeller. Closed, or with gaps that are mended.</source>
        <translation>Aus einem Scanner oder einem 3D-Programm. Geschlossen, oder mit Lücken, die geschlossen werden.</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Labels, colours or ranges of grey become tissues.</source>
        <translation>Kennwerte, Farben oder Graubereiche werden zu Geweben.</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>One slice names its series. Nothing about the patient is read.</source>
        <translation>Eine Schicht nennt ihre Serie. Über die Person auf den Aufnahmen wird nichts gelesen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportPage</name>
    <message>
        <source>Import a specimen</source>
        <translation>Präparat importieren</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Make a specimen</source>
        <translation>Präparat erstellen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Importing was stopped.</source>
        <translation>Das Importieren wurde angehalten.</translation>
    </message>
    <message>
        <source>Nothing was kept.</source>
        <translation>Nichts wurde aufbewahrt.</translation>
    </message>
    <message>
        <source>These files are not opened together.</source>
        <translation>Diese Dateien lassen sich nicht zusammen öffnen.</translation>
    </message>
    <message>
        <source>%1 does not go with the others. Surfaces go together, and slices of one CT. Choose any other file alone, and of a header with its data the header.</source>
        <translation>%1 passt nicht zu den anderen. Zusammen gehen Oberflächen und die Schichten eines CT. Wählen Sie jede andere Datei allein, und von Kopf- und Datendatei die Kopfdatei.</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Die Datei wird gelesen</translation>
    </message>
    <message>
        <source>The specimen will be %1.</source>
        <translation>Das Präparat wird %1 groß.</translation>
    </message>
    <message>
        <source>With this unit the file is %1. Choose the tissue of each mesh.</source>
        <translation>Mit dieser Einheit ist die Datei %1 groß. Wählen Sie das Gewebe jedes Netzes.</translation>
    </message>
    <message>
        <source>Making the specimen</source>
        <translation>Das Präparat wird erstellt</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>Woraus es besteht</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Add a file…</source>
        <translation>Datei hinzufügen …</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels of %4.</source>
        <translation>%1 × %2 × %3 Voxel zu %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n slice(s) of a CT, in the order of their places.</source>
        <translation>
            <numerusform>%n Schicht eines CT.</numerusform>
            <numerusform>%n Schichten eines CT, nach ihrer Lage geordnet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its folder holds %n series. Of a slice its own is taken, of a folder the largest.</source>
        <translation>
            <numerusform>Der Ordner enthält %n Serie.</numerusform>
            <numerusform>Der Ordner enthält %n Serien. Zu einer Schicht gehört ihre eigene, von einem Ordner wird die größte genommen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing about the patient is read.</source>
        <translation>Über die Person auf den Aufnahmen wird nichts gelesen.</translation>
    </message>
    <message>
        <source>The volume is %1.</source>
        <translation>Das Volumen misst %1.</translation>
    </message>
    <message>
        <source>Its voxels of %1 are resampled to cubes of %2.</source>
        <translation>Seine Voxel zu %1 werden in Würfel zu %2 umgerechnet.</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>The specimen, before it is kept</source>
        <translation>Das Präparat, bevor es behalten wird</translation>
    </message>
    <message>
        <source>Meshes and volumes (*.stl *.obj *.ply *.3ds *.off *.nrrd *.mha *.mhd *.nii *.nii.gz *.hdr *.binvox *.dcm *.ima);;All files (*)</source>
        <translation>Netze und Volumen (*.stl *.obj *.ply *.3ds *.off *.nrrd *.mha *.mhd *.nii *.nii.gz *.hdr *.binvox *.dcm *.ima);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Keep it and make an exercise</source>
        <translation>Behalten und Übung anlegen</translation>
    </message>
    <message>
        <source>If its unit were a millimetre, it would be %1.</source>
        <translation>Wäre die Einheit ein Millimeter, so wären es %1.</translation>
    </message>
    <message>
        <source>The specimen is made. Look at it, and keep it.</source>
        <translation>Das Präparat ist fertig. Ansehen und behalten.</translation>
    </message>
    <message>
        <source>Making the exercise</source>
        <translation>Übung wird angelegt</translation>
    </message>
    <message>
        <source>Make the specimen anew from its scan or its surfaces.</source>
        <translation>Erstellen Sie das Präparat neu aus seinem Scan oder seinen Oberflächen.</translation>
    </message>
    <message>
        <source>Leave the import?</source>
        <translation>Den Import verlassen?</translation>
    </message>
    <message>
        <source>The files stay as they are. What was read of them and what you chose here is not kept.</source>
        <translation>Die Dateien bleiben, wie sie sind. Was aus ihnen gelesen wurde und was Sie hier gewählt haben, bleibt nicht erhalten.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportPreview</name>
    <message>
        <source>The imported specimen</source>
        <translation>Das importierte Präparat</translation>
    </message>
    <message>
        <source>The arrow points to where the bur comes from: the chewing surface has to look that way. A turn by these buttons is kept; the mouse only moves the view.</source>
        <translation>Der Pfeil zeigt dorthin, woher der Bohrer kommt: Dorthin muss die Kaufläche zeigen. Eine Drehung mit diesen Knöpfen bleibt; die Maus bewegt nur die Ansicht.</translation>
    </message>
    <message>
        <source>Tip back</source>
        <translation>Nach hinten kippen</translation>
    </message>
    <message>
        <source>Tip forward</source>
        <translation>Nach vorn kippen</translation>
    </message>
    <message>
        <source>Tip left</source>
        <translation>Nach links kippen</translation>
    </message>
    <message>
        <source>Tip right</source>
        <translation>Nach rechts kippen</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Nach links drehen</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>A quarter turn of the specimen about %1</source>
        <translation>Eine Vierteldrehung des Präparats um %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportSize</name>
    <message>
        <source>Millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Micrometre</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Eine andere</translation>
    </message>
    <message>
        <source>One unit of the file is</source>
        <translation>Eine Einheit der Datei ist</translation>
    </message>
    <message>
        <source>Its length</source>
        <translation>Ihre Länge</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Axis of the file that points up</source>
        <translation>Achse der Datei, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Is the unit right?</source>
        <translation>Stimmt die Einheit?</translation>
    </message>
    <message>
        <source>× %1: %2</source>
        <translation>× %1: %2</translation>
    </message>
    <message>
        <source>It is %1</source>
        <translation>Es sind %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ImportText</name>
    <message>
        <source>Its voxels of %1 were resampled to cubes of %2.</source>
        <translation>Seine Voxel zu %1 wurden in Würfel zu %2 umgerechnet.</translation>
    </message>
    <message>
        <source>Its axes were oblique; it was turned by %1°, its shape is as it was.</source>
        <translation>Seine Achsen standen schief; es wurde um %1° gedreht, seine Form ist unverändert.</translation>
    </message>
    <message>
        <source>The file does not name its unit; the chosen one was taken.</source>
        <translation>Die Datei nennt keine Einheit; die gewählte gilt.</translation>
    </message>
    <message>
        <source>Nothing about the patient was read.</source>
        <translation>Über die Person auf den Aufnahmen wurde nichts gelesen.</translation>
    </message>
    <message numerus="yes">
        <source>The folder holds %n series; the one with %1 slices was read.</source>
        <translation>
            <numerusform>Der Ordner enthält %n Serie; die mit %1 Schichten wurde gelesen.</numerusform>
            <numerusform>Der Ordner enthält %n Serien; die mit %1 Schichten wurde gelesen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n point(s) that lay in one place were joined.</source>
        <translation>
            <numerusform>In %1 wurde %n Punkt mit seinem Nachbarn verbunden.</numerusform>
            <numerusform>In %1 wurden %n Punkte verbunden, die an einer Stelle lagen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n triangle(s) too many were left out.</source>
        <translation>
            <numerusform>In %1 wurde %n überzähliges Dreieck weggelassen.</numerusform>
            <numerusform>In %1 wurden %n überzählige Dreiecke weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n triangle(s) were turned round.</source>
        <translation>
            <numerusform>In %1 wurde %n Dreieck gewendet.</numerusform>
            <numerusform>In %1 wurden %n Dreiecke gewendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In %1 %n hole(s) were closed, the widest of %2.</source>
        <translation>
            <numerusform>In %1 wurde %n Loch von %2 geschlossen.</numerusform>
            <numerusform>In %1 wurden %n Löcher geschlossen, das breiteste von %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n voxel(s) of separate components were left out.</source>
        <translation>
            <numerusform>%n Voxel getrennter Komponenten wurde weggelassen.</numerusform>
            <numerusform>%n Voxel getrennter Komponenten wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n voxel(s) of closed hollows were filled.</source>
        <translation>
            <numerusform>%n Voxel geschlossener Hohlräume wurde gefüllt.</numerusform>
            <numerusform>%n Voxel geschlossener Hohlräume wurden gefüllt.</numerusform>
        </translation>
    </message>
    <message>
        <source>× %1 = %2</source>
        <translation>× %1 = %2</translation>
    </message>
    <message>
        <source>Is the unit right? %1.</source>
        <translation>Stimmt die Einheit? %1.</translation>
    </message>
    <message>
        <source>Is the unit right? Else take fewer parts, or crop the file.</source>
        <translation>Stimmt die Einheit? Sonst weniger Teile nehmen oder die Datei zuschneiden.</translation>
    </message>
    <message>
        <source>Voxels of %1 would fit; or take fewer parts, or crop the file.</source>
        <translation>Voxel von %1 würden passen; oder weniger Teile nehmen oder die Datei zuschneiden.</translation>
    </message>
    <message>
        <source>%1 was an open shell. Caps of %2 closed it; what lies between shell and cap is %3, unless another part lies there.</source>
        <translation>%1 war eine offene Hülle. Deckel von %2 haben sie geschlossen; was zwischen Hülle und Deckel liegt, ist %3, sofern dort kein anderer Teil liegt.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3; it became %4 (%1), not %5.</source>
        <translation>%1 und %2 überschneiden sich um %3; daraus wurde %4 (%1), nicht %5.</translation>
    </message>
    <message>
        <source>%1 lies inside %2; its %3 became %4.</source>
        <translation>%1 liegt in %2; daraus (%3) wurde %4.</translation>
    </message>
    <message>
        <source>Where parts overlap, the order given decides: %1.</source>
        <translation>Wo sich Teile überschneiden, entscheidet die angegebene Reihenfolge: %1.</translation>
    </message>
    <message>
        <source>Where parts overlap, the innermost wins: %1.</source>
        <translation>Wo sich Teile überschneiden, gilt der innerste: %1.</translation>
    </message>
    <message>
        <source>It is only %1 long: shorter than any tooth.</source>
        <translation>Es ist nur %1 lang: kürzer als jeder Zahn.</translation>
    </message>
    <message>
        <source>It is %1 long: longer than any tooth or dental arch.</source>
        <translation>Es ist %1 lang: länger als jeder Zahn oder Zahnbogen.</translation>
    </message>
    <message>
        <source>The specimen would be too large.</source>
        <translation>Das Präparat würde zu groß.</translation>
    </message>
    <message>
        <source>This file is too large.</source>
        <translation>Diese Datei ist zu groß.</translation>
    </message>
    <message>
        <source>The import was ended by a limit.</source>
        <translation>Der Import wurde von einer Grenze beendet.</translation>
    </message>
    <message>
        <source>%1 would take %2 million voxels (%3 MB); %4 million (%5 MB) are allowed.</source>
        <translation>%1 bräuchte %2 Millionen Voxel (%3 MB); erlaubt sind %4 Millionen (%5 MB).</translation>
    </message>
    <message>
        <source>%1 would be %2 voxels long; %3 are allowed.</source>
        <translation>%1 wäre %2 Voxel lang; erlaubt sind %3.</translation>
    </message>
    <message>
        <source>%1 holds %2 million voxels; %3 million are allowed. Crop it, or make it coarser, in the program that it comes from.</source>
        <translation>%1 enthält %2 Millionen Voxel; erlaubt sind %3 Millionen. Im Programm, aus dem die Datei stammt, zuschneiden oder vergröbern.</translation>
    </message>
    <message>
        <source>%1 is %2 voxels long; %3 are allowed. Crop it, or make it coarser, in the program that it comes from.</source>
        <translation>%1 ist %2 Voxel lang; erlaubt sind %3. Im Programm, aus dem die Datei stammt, zuschneiden oder vergröbern.</translation>
    </message>
    <message>
        <source>%1 has %2 MB; %3 MB are allowed. Save it with fewer triangles.</source>
        <translation>%1 hat %2 MB; erlaubt sind %3 MB. Mit weniger Dreiecken speichern.</translation>
    </message>
    <message>
        <source>%1 is made of more than %2 files.</source>
        <translation>%1 besteht aus mehr als %2 Dateien.</translation>
    </message>
    <message>
        <source>Reading %1 took more than the %2 MB of memory that an import may use. Take larger voxels, or crop the file.</source>
        <translation>Das Lesen von %1 brauchte mehr als die %2 MB Speicher, die ein Import belegen darf. Größere Voxel nehmen oder die Datei zuschneiden.</translation>
    </message>
    <message>
        <source>Reading %1 took more than the %2 s of processor time that an import may use. Take larger voxels, or crop the file.</source>
        <translation>Das Lesen von %1 brauchte mehr als die %2 s Rechenzeit, die ein Import nutzen darf. Größere Voxel nehmen oder die Datei zuschneiden.</translation>
    </message>
    <message>
        <source>Reading %1 took longer than the %2 s that an import may last. Take larger voxels, or crop the file.</source>
        <translation>Das Lesen von %1 dauerte länger als die %2 s, die ein Import dauern darf. Größere Voxel nehmen oder die Datei zuschneiden.</translation>
    </message>
    <message>
        <source>The file does not name the directions of its axes: the specimen may be the mirror image of the tooth. Compare them.</source>
        <translation>Die Datei nennt die Richtungen ihrer Achsen nicht: Das Präparat kann das Spiegelbild des Zahns sein. Vergleichen Sie beide.</translation>
    </message>
    <message>
        <source>%1 was wound inside out, as a mirrored copy is: the specimen may be the mirror image of the tooth. Compare them.</source>
        <translation>%1 war nach innen gewendet wie eine gespiegelte Kopie: Das Präparat kann das Spiegelbild des Zahns sein. Vergleichen Sie beide.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::InterruptedCard</name>
    <message>
        <source>A scripted operator cut it, so it cannot be continued by hand.</source>
        <translation>Ein automatischer Operateur hat ihn ausgeführt; von Hand kann er nicht fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Interrupted attempt</source>
        <translation>Unterbrochener Versuch</translation>
    </message>
    <message>
        <source>%1, attempt %2</source>
        <translation>%1, Versuch %2</translation>
    </message>
    <message>
        <source>Grade as it stands</source>
        <translation>Bewerten, wie er ist</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Interrupted assessment</source>
        <translation>Unterbrochene Prüfung</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>It broke off after %1. All of it is kept.</source>
        <translation>Sie brach nach %1 ab. Alles davon ist aufbewahrt.</translation>
    </message>
    <message>
        <source>It broke off after %1, before anything was cut.</source>
        <translation>Er brach nach %1 ab, bevor etwas abgetragen war.</translation>
    </message>
    <message>
        <source>It broke off after %1, with %2 cut. All of that is kept.</source>
        <translation>Er brach nach %1 ab; %2 waren abgetragen. All das ist aufbewahrt.</translation>
    </message>
    <message>
        <source>An older version of Cusp ended it without a grade, so it cannot be continued.</source>
        <translation>Eine ältere Version von Cusp hat ihn ohne Bewertung beendet; fortgesetzt werden kann er nicht.</translation>
    </message>
    <message>
        <source>It was cut with: %1. This station drills with: %2. To continue it here, ask the staff to choose the first one on the page Device.</source>
        <translation>Präpariert wurde mit: %1. Diese Station präpariert mit: %2. Um den Versuch hier fortzusetzen, bitten Sie das Personal, auf der Seite Gerät das erste zu wählen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::InversePanel</name>
    <message>
        <source>It is reached through its maker&apos;s own service on this computer, which you install. Not yet tried with a real device: its directions, forces and rate are not verified.</source>
        <translation>Es wird über den Dienst seines Herstellers auf diesem Rechner erreicht, den Sie installieren. Noch nicht mit einem echten Gerät erprobt: Richtungen, Kräfte und Rate sind nicht überprüft.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Answers a second</source>
        <translation>Antworten je Sekunde</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>Wie es kommt</translation>
    </message>
    <message>
        <source>A quarter to the left</source>
        <translation>Ein Viertel nach links</translation>
    </message>
    <message>
        <source>Half round</source>
        <translation>Halb herum</translation>
    </message>
    <message>
        <source>A quarter to the right</source>
        <translation>Ein Viertel nach rechts</translation>
    </message>
    <message>
        <source>It stands turned</source>
        <translation>Es steht gedreht</translation>
    </message>
    <message>
        <source>Of the hand&apos;s way</source>
        <translation>Vom Weg der Hand</translation>
    </message>
    <message>
        <source>Port of the service</source>
        <translation>Port des Dienstes</translation>
    </message>
    <message>
        <source>Look for it</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Release it</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>nicht gefragt</translation>
    </message>
    <message>
        <source>Start its service, switch the device on, and look for it.</source>
        <translation>Starten Sie seinen Dienst, schalten Sie das Gerät ein und suchen Sie es.</translation>
    </message>
    <message>
        <source>asking</source>
        <translation>fragt</translation>
    </message>
    <message>
        <source>Asking the service.</source>
        <translation>Der Dienst wird gefragt.</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>No service answers at port %1. Start the maker&apos;s service and look again.</source>
        <translation>An Port %1 antwortet kein Dienst. Starten Sie den Dienst des Herstellers und suchen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The service answers, but it knows of no Inverse3. Check its cable and power, and look again.</source>
        <translation>Der Dienst antwortet, kennt aber kein Inverse3. Prüfen Sie Kabel und Strom und suchen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not as an Inverse3&apos;s service does.</source>
        <translation>An Port %1 antwortet etwas, aber nicht wie der Dienst eines Inverse3.</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>Move it: the place below follows the hand.</source>
        <translation>Bewegen Sie es: Der Ort unten folgt der Hand.</translation>
    </message>
    <message>
        <source>It does not answer any more. It is looked for by itself; there is no force meanwhile.</source>
        <translation>Es antwortet nicht mehr. Es wird von selbst gesucht; bis dahin gibt es keine Kraft.</translation>
    </message>
    <message>
        <source>None: the bur keeps its axis</source>
        <translation>Keiner: Der Bohrer behält seine Achse</translation>
    </message>
    <message>
        <source>Reports how it is turned</source>
        <translation>Meldet, wie er gedreht ist</translation>
    </message>
    <message>
        <source>Pressed: %1</source>
        <translation>Gedrückt: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Its handle does not report any more. Switch the handle on; there is no force meanwhile.</source>
        <translation>Sein Griff meldet sich nicht mehr. Schalten Sie den Griff ein; bis dahin gibt es keine Kraft.</translation>
    </message>
    <message>
        <source>Does not report</source>
        <translation>Meldet sich nicht</translation>
    </message>
</context>
<context>
    <name>cusp::ui::KeptBand</name>
    <message>
        <source>What is changed here holds until Cusp is closed.</source>
        <translation>Was hier geändert wird, gilt, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know it.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start es nicht.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LandmarkText</name>
    <message>
        <source>Long axis</source>
        <translation>Längsachse</translation>
    </message>
    <message>
        <source>Mesial direction</source>
        <translation>Mesiale Richtung</translation>
    </message>
    <message>
        <source>Cusp tip</source>
        <translation>Höckerspitze</translation>
    </message>
    <message>
        <source>Pit</source>
        <translation>Grube</translation>
    </message>
    <message>
        <source>Fissure</source>
        <translation>Fissur</translation>
    </message>
    <message>
        <source>Marginal ridge</source>
        <translation>Randleiste</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Cemento-enamel junction</source>
        <translation>Schmelz-Zement-Grenze</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>die einzige</translation>
    </message>
    <message>
        <source>incisal</source>
        <translation>inzisal</translation>
    </message>
    <message>
        <source>central</source>
        <translation>zentral</translation>
    </message>
    <message>
        <source>mesial</source>
        <translation>mesial</translation>
    </message>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>bukkal</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>lingual</translation>
    </message>
    <message>
        <source>central mesial</source>
        <translation>zentral mesial</translation>
    </message>
    <message>
        <source>central distal</source>
        <translation>zentral distal</translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation>mesiobukkal</translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation>distobukkal</translation>
    </message>
    <message>
        <source>mesiolingual</source>
        <translation>mesiolingual</translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation>distolingual</translation>
    </message>
    <message>
        <source>mesiobuccal triangular</source>
        <translation>mesiobukkal dreieckig</translation>
    </message>
    <message>
        <source>distobuccal triangular</source>
        <translation>distobukkal dreieckig</translation>
    </message>
    <message>
        <source>mesiolingual triangular</source>
        <translation>mesiolingual dreieckig</translation>
    </message>
    <message>
        <source>distolingual triangular</source>
        <translation>distolingual dreieckig</translation>
    </message>
    <message>
        <source>mesial marginal</source>
        <translation>mesial am Rand</translation>
    </message>
    <message>
        <source>distal oblique</source>
        <translation>distal schräg</translation>
    </message>
    <message>
        <source>transverse of the oblique ridge</source>
        <translation>quer zur Crista obliqua</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a kind of landmark (&quot;Cusp tip&quot;), %2: which one (&quot;MB&quot;)</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Apical end</source>
        <translation>Apikales Ende</translation>
    </message>
    <message>
        <source>Occlusal end</source>
        <translation>Okklusales Ende</translation>
    </message>
    <message>
        <source>Distal end</source>
        <translation>Distales Ende</translation>
    </message>
    <message>
        <source>Mesial end</source>
        <translation>Mesiales Ende</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>No landmark can be proposed.</source>
        <translation>Keine Landmarke kann vorgeschlagen werden.</translation>
    </message>
    <message>
        <source>No tooth has that number.</source>
        <translation>Kein Zahn hat diese Nummer.</translation>
    </message>
    <message>
        <source>This volume holds no hard tissue of a tooth.</source>
        <translation>Dieses Volumen enthält keine Zahnhartsubstanz.</translation>
    </message>
    <message>
        <source>Nothing in this volume has the form of a tooth whose crown lies up.</source>
        <translation>Nichts in diesem Volumen hat die Form eines Zahns, dessen Krone oben liegt.</translation>
    </message>
    <message>
        <source>The crown is unlike that of tooth %1.</source>
        <translation>Die Krone gleicht der von Zahn %1 nicht.</translation>
    </message>
    <message>
        <source>What goes by that likeness is left out. Check the number, and that the crown lies up in the file.</source>
        <translation>Was sich danach richtet, fehlt. Zu prüfen sind die Nummer und ob die Krone in der Datei oben liegt.</translation>
    </message>
    <message>
        <source>supplementary</source>
        <translation>zusätzlich</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LandmarksForm</name>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Number of the tooth</source>
        <translation>Nummer des Zahns</translation>
    </message>
    <message>
        <source>Propose landmarks</source>
        <translation>Landmarken vorschlagen</translation>
    </message>
    <message>
        <source>By the average tooth of that number. Landmarks that are set stay while the number does.</source>
        <translation>Nach dem mittleren Zahn dieser Nummer. Gesetzte Landmarken bleiben, solange die Nummer bleibt.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>The chosen landmark is set where it lies</source>
        <translation>Die gewählte Landmarke wird gesetzt, wo sie liegt</translation>
    </message>
    <message>
        <source>Accept all</source>
        <translation>Alle übernehmen</translation>
    </message>
    <message>
        <source>Remove the landmark</source>
        <translation>Landmarke entfernen</translation>
    </message>
    <message>
        <source>Point of the landmark</source>
        <translation>Punkt der Landmarke</translation>
    </message>
    <message>
        <source>Along the arch</source>
        <translation>Entlang des Zahnbogens</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Landmark: %1</source>
        <translation>Landmarke: %1</translation>
    </message>
    <message>
        <source>Looking for landmarks</source>
        <translation>Landmarken werden gesucht</translation>
    </message>
    <message>
        <source>The landmarks cannot be taken.</source>
        <translation>Die Landmarken können nicht übernommen werden.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 proposed, %2 set</source>
        <extracomment>%1, %2: numbers of landmarks</extracomment>
        <translation>%1 vorgeschlagen, %2 gesetzt</translation>
    </message>
    <message>
        <source>Towards buccal</source>
        <translation>Nach bukkal</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LibraryModel</name>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Draft of the next</source>
        <translation>Entwurf der nächsten</translation>
    </message>
    <message>
        <source>Comes with Cusp</source>
        <translation>Liegt Cusp bei</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Veröffentlicht</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Draft saved</source>
        <translation>Entwurf gespeichert</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Version %1 withdrawn</source>
        <translation>Version %1 zurückgezogen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LibraryPage</name>
    <message>
        <source>Discard the draft</source>
        <translation>Entwurf verwerfen</translation>
    </message>
    <message>
        <source>Discard the draft of %1?</source>
        <translation>Den Entwurf von %1 verwerfen?</translation>
    </message>
    <message>
        <source>What is published stays as it is.</source>
        <translation>Was veröffentlicht ist, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>It was never published: nothing of it is left.</source>
        <translation>Er wurde nie veröffentlicht: Es bleibt nichts davon.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Import a specimen</source>
        <translation>Präparat importieren</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>Neue Übung</translation>
    </message>
    <message>
        <source>Open in the editor</source>
        <translation>Im Editor öffnen</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s) cannot be read.</source>
        <translation>
            <numerusform>%n Übung kann nicht gelesen werden.</numerusform>
            <numerusform>%n Übungen können nicht gelesen werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>The others are below.</source>
        <translation>Die anderen stehen unten.</translation>
    </message>
    <message>
        <source>A draft has nothing to copy yet.</source>
        <translation>Ein Entwurf hat noch nichts zum Kopieren.</translation>
    </message>
    <message>
        <source>Publish it first.</source>
        <translation>Veröffentlichen Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>The draft was changed in another window meanwhile.</source>
        <translation>Der Entwurf wurde inzwischen in einem anderen Fenster geändert.</translation>
    </message>
    <message>
        <source>It was not discarded. The list shows it as it is now.</source>
        <translation>Er wurde nicht verworfen. Die Liste zeigt ihn, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>Find an exercise</source>
        <translation>Übung finden</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Save the exercise as a file</source>
        <translation>Die Übung als Datei speichern</translation>
    </message>
    <message>
        <source>exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Exercise (*%1)</source>
        <translation>Übung (*%1)</translation>
    </message>
    <message>
        <source>The file is %1. Another station opens it in its library.</source>
        <translation>Die Datei heißt %1. Eine andere Station öffnet sie in ihrer Bibliothek.</translation>
    </message>
    <message>
        <source>Version %1 of %2 is saved as a file.</source>
        <translation>Version %1 von %2 ist als Datei gespeichert.</translation>
    </message>
    <message>
        <source>The draft of %1 is saved as a file.</source>
        <translation>Der Entwurf von %1 ist als Datei gespeichert.</translation>
    </message>
    <message>
        <source>Your draft of the next version is not in it.</source>
        <translation>Ihr Entwurf der nächsten Version ist nicht darin.</translation>
    </message>
    <message>
        <source>Open an exercise</source>
        <translation>Eine Übung öffnen</translation>
    </message>
    <message>
        <source>%1 is in the library already.</source>
        <translation>%1 ist schon in der Bibliothek.</translation>
    </message>
    <message>
        <source>The file holds the same. Nothing was changed.</source>
        <translation>Die Datei enthält dasselbe. Nichts wurde verändert.</translation>
    </message>
    <message>
        <source>Open %1 as a new exercise?</source>
        <translation>%1 als neue Übung öffnen?</translation>
    </message>
    <message>
        <source>The library has this exercise with another content. It stays as it is; the file becomes an exercise beside it.</source>
        <translation>Die Bibliothek hat diese Übung mit anderem Inhalt. Sie bleibt, wie sie ist; die Datei wird eine Übung daneben.</translation>
    </message>
    <message>
        <source>Open as a new exercise</source>
        <translation>Als neue Übung öffnen</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Eine Datei öffnen …</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More for the chosen exercise</source>
        <translation>Mehr zur gewählten Übung</translation>
    </message>
    <message>
        <source>Save as file…</source>
        <translation>Als Datei speichern …</translation>
    </message>
    <message>
        <source>Withdraw…</source>
        <translation>Zurückziehen …</translation>
    </message>
    <message>
        <source>Discard the draft…</source>
        <translation>Entwurf verwerfen …</translation>
    </message>
    <message>
        <source>Students find version %1 again.</source>
        <translation>Studierende finden wieder Version %1.</translation>
    </message>
    <message>
        <source>Students no longer find this exercise; you keep it as a draft.</source>
        <translation>Studierende finden diese Übung nicht mehr; Sie behalten sie als Entwurf.</translation>
    </message>
    <message numerus="yes">
        <source>%n open assignment(s) of this version can no longer be drilled.</source>
        <translation>
            <numerusform>%n offene Zuweisung dieser Version kann nicht mehr bearbeitet werden.</numerusform>
            <numerusform>%n offene Zuweisungen dieser Version können nicht mehr bearbeitet werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Results and reports stay. A withdrawn version does not come back: publishing makes a new one.</source>
        <translation>Ergebnisse und Berichte bleiben. Eine zurückgezogene Version kommt nicht zurück: Veröffentlichen macht eine neue.</translation>
    </message>
    <message>
        <source>Withdraw version %1 of %2?</source>
        <translation>Version %1 von %2 zurückziehen?</translation>
    </message>
    <message>
        <source>Withdraw version %1</source>
        <translation>Version %1 zurückziehen</translation>
    </message>
    <message>
        <source>Version %1 of %2 is withdrawn.</source>
        <translation>Version %1 von %2 ist zurückgezogen.</translation>
    </message>
    <message>
        <source>It stays here as a draft of yours.</source>
        <translation>Sie bleibt hier als Ihr Entwurf.</translation>
    </message>
    <message>
        <source>From a template: %1…</source>
        <translation>Aus einer Vorlage: %1 …</translation>
    </message>
    <message>
        <source>%1 is being written.</source>
        <translation>%1 wird geschrieben.</translation>
    </message>
    <message>
        <source>%1 is being read.</source>
        <translation>%1 wird gelesen.</translation>
    </message>
    <message>
        <source>%1 is being opened.</source>
        <translation>%1 wird geöffnet.</translation>
    </message>
    <message>
        <source>No exercise fits</source>
        <translation>Keine Übung passt</translation>
    </message>
    <message>
        <source>Show all exercises</source>
        <translation>Alle Übungen zeigen</translation>
    </message>
    <message>
        <source>No exercise and no tooth of this group and state has this text.</source>
        <translation>Keine Übung und kein Zahn dieser Gruppe und dieses Stands enthält diesen Text.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>Jeder Stand</translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s)</source>
        <translation>
            <numerusform>%n Übung</numerusform>
            <numerusform>%n Übungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Another file is still being written or read.</source>
        <translation>Eine andere Datei wird noch geschrieben oder gelesen.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Noch einmal speichern</translation>
    </message>
    <message>
        <source>%1 was not opened.</source>
        <translation>%1 wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Noch einmal öffnen</translation>
    </message>
    <message>
        <source>Its versions are withdrawn: without the draft you cannot edit or publish it again. Results and reports stay.</source>
        <translation>Die Versionen der Übung sind zurückgezogen: Ohne den Entwurf können Sie sie nicht mehr bearbeiten und nicht erneut veröffentlichen. Ergebnisse und Berichte bleiben.</translation>
    </message>
    <message>
        <source>The versions or assignments of %1 changed meanwhile.</source>
        <translation>Die Versionen oder Zuweisungen von %1 haben sich inzwischen geändert.</translation>
    </message>
    <message>
        <source>Nothing was withdrawn. Withdraw it again to see what follows now.</source>
        <translation>Nichts wurde zurückgezogen. Ziehen Sie sie erneut zurück, um zu sehen, was jetzt folgt.</translation>
    </message>
    <message>
        <source>The file is %1 and holds what was published. The checks refuse that now, and so does a station that opens the file: %2 Mend it in the editor and publish it again.</source>
        <translation>Die Datei heißt %1 und enthält, was veröffentlicht wurde. Die Prüfungen lehnen das jetzt ab, und eine Station, die die Datei öffnet, ebenso: %2 Beheben Sie es im Editor und veröffentlichen Sie die Übung erneut.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LogModel</name>
    <message>
        <source>breaks the chain</source>
        <translation>bricht die Kette</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>stimmt</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>nicht bewiesen</translation>
    </message>
    <message>
        <source>erased account</source>
        <translation>gelöschtes Konto</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Concerns</source>
        <translation>Betrifft</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Prüfung</translation>
    </message>
</context>
<context>
    <name>cusp::ui::LogPage</name>
    <message>
        <source>Audit log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Verify now</source>
        <translation>Jetzt prüfen</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>All dates</source>
        <translation>Gesamter Zeitraum</translation>
    </message>
    <message numerus="yes">
        <source>Last %n day(s)</source>
        <translation>
            <numerusform>Letzter Tag</numerusform>
            <numerusform>Letzte %n Tage</numerusform>
        </translation>
    </message>
    <message>
        <source>Between two days</source>
        <translation>Zwischen zwei Tagen</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Letzter Tag</translation>
    </message>
    <message>
        <source>Entries of the audit log</source>
        <translation>Einträge des Protokolls</translation>
    </message>
    <message>
        <source>No entry fits</source>
        <translation>Kein Eintrag passt</translation>
    </message>
    <message>
        <source>The log has no entry of this kind, person and date.</source>
        <translation>Das Protokoll hat keinen Eintrag dieser Art, dieser Person und dieser Zeit.</translation>
    </message>
    <message>
        <source>Show all entries</source>
        <translation>Alle Einträge zeigen</translation>
    </message>
    <message>
        <source>All people</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>this station</source>
        <translation>diese Station</translation>
    </message>
    <message>
        <source>Verifying the audit log</source>
        <translation>Das Protokoll wird geprüft</translation>
    </message>
    <message>
        <source>%1 of %2 entries</source>
        <translation>%1 von %2 Einträgen</translation>
    </message>
    <message>
        <source>It says: %1, %2.</source>
        <translation>In ihm steht: %1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>The log is whole: %n entry(ies) hold.</source>
        <translation>
            <numerusform>Das Protokoll ist unversehrt: %n Eintrag stimmt.</numerusform>
            <numerusform>Das Protokoll ist unversehrt: %n Einträge stimmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Verified %1.</source>
        <translation>Geprüft um %1.</translation>
    </message>
    <message>
        <source>The end of the log does not hold: entries were changed, added or taken out.</source>
        <translation>Das Ende des Protokolls hält nicht: Einträge wurden geändert, hinzugefügt oder entfernt.</translation>
    </message>
    <message>
        <source>Entry %1 is missing: the chain breaks there.</source>
        <translation>Eintrag %1 fehlt: Dort bricht die Kette.</translation>
    </message>
    <message>
        <source>Entry %1 breaks the chain: it was changed.</source>
        <translation>Eintrag %1 bricht die Kette: Er wurde geändert.</translation>
    </message>
    <message>
        <source>The entries before it hold.</source>
        <translation>Die Einträge davor halten.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) exported.</source>
        <translation>
            <numerusform>%n Eintrag exportiert.</numerusform>
            <numerusform>%n Einträge exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting the audit log</source>
        <translation>Das Protokoll wird exportiert</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 was not written. What was there before is unchanged.</source>
        <translation>%1 wurde nicht geschrieben. Was vorher da war, ist unverändert.</translation>
    </message>
    <message>
        <source>The entries could not be read.</source>
        <translation>Die Einträge konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Older entries are not shown: they could not be read.</source>
        <translation>Ältere Einträge sind nicht angezeigt: Sie konnten nicht gelesen werden.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::MarkingCard</name>
    <message>
        <source>The result was changed at another desk meanwhile.</source>
        <translation>Das Ergebnis wurde inzwischen an einem anderen Platz geändert.</translation>
    </message>
    <message>
        <source>The report shows it as it counts now. Nothing was stated.</source>
        <translation>Der Bericht zeigt es, wie es jetzt zählt. Es wurde nichts festgehalten.</translation>
    </message>
    <message>
        <source>Marking</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>A comment, or the reason for a change</source>
        <translation>Ein Kommentar, oder die Begründung einer Änderung</translation>
    </message>
    <message>
        <source>Comment or reason</source>
        <translation>Kommentar oder Begründung</translation>
    </message>
    <message>
        <source>at the place of the chosen criterion</source>
        <translation>an der Stelle des gewählten Kriteriums</translation>
    </message>
    <message>
        <source>Add comment</source>
        <translation>Kommentar hinzufügen</translation>
    </message>
    <message>
        <source>Change points</source>
        <translation>Punkte ändern</translation>
    </message>
    <message>
        <source>Critical event</source>
        <translation>Kritisches Ereignis</translation>
    </message>
    <message>
        <source>Does not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Confirm the result</source>
        <translation>Ergebnis bestätigen</translation>
    </message>
    <message>
        <source>Release to the student</source>
        <translation>Ergebnis freigeben</translation>
    </message>
    <message>
        <source>The result is confirmed as it stands.</source>
        <translation>Das Ergebnis ist bestätigt, wie es steht.</translation>
    </message>
    <message>
        <source>The student can read the result now.</source>
        <translation>Das Ergebnis ist jetzt freigegeben und lesbar.</translation>
    </message>
    <message>
        <source>What was said</source>
        <translation>Was gesagt wurde</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Choose a criterion to change its points.</source>
        <translation>Wählen Sie ein Kriterium, um dessen Punkte zu ändern.</translation>
    </message>
    <message>
        <source>%1, of %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>Punkte von %1</translation>
    </message>
    <message>
        <source>released</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>withheld from the student</source>
        <translation>zurückgehalten</translation>
    </message>
    <message>
        <source>A failed result is confirmed first</source>
        <translation>Ein nicht bestandenes Ergebnis wird zuerst bestätigt</translation>
    </message>
    <message>
        <source>The comment is empty.</source>
        <translation>Der Kommentar ist leer.</translation>
    </message>
    <message>
        <source>The comment is kept.</source>
        <translation>Der Kommentar ist aufbewahrt.</translation>
    </message>
    <message>
        <source>A change needs a reason.</source>
        <translation>Eine Änderung braucht eine Begründung.</translation>
    </message>
    <message>
        <source>The points are changed. The measured grade is kept beside them.</source>
        <translation>Die Punkte sind geändert. Die gemessene Bewertung bleibt daneben erhalten.</translation>
    </message>
    <message>
        <source>The critical event no longer counts.</source>
        <translation>Das kritische Ereignis zählt nicht mehr.</translation>
    </message>
    <message>
        <source>Write the reason below.</source>
        <translation>Schreiben Sie die Begründung unten.</translation>
    </message>
    <message>
        <source>Taking back needs a reason.</source>
        <translation>Zurücknehmen braucht eine Begründung.</translation>
    </message>
    <message>
        <source>It is taken back. Both stay in the records.</source>
        <translation>Es ist zurückgenommen. Beides bleibt in den Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Mark this attempt</source>
        <translation>Diesen Versuch bewerten</translation>
    </message>
    <message>
        <source>Comment, change points, confirm or release</source>
        <translation>Kommentieren, Punkte ändern, bestätigen oder freigeben</translation>
    </message>
    <message>
        <source>Write it below.</source>
        <translation>Schreiben Sie ihn unten.</translation>
    </message>
    <message>
        <source>Write it below; the student reads it.</source>
        <translation>Schreiben Sie sie unten; sie ist mit dem Ergebnis lesbar.</translation>
    </message>
    <message>
        <source>These are the points that count already.</source>
        <translation>Diese Punkte zählen bereits.</translation>
    </message>
    <message>
        <source>Type other points.</source>
        <translation>Geben Sie andere Punkte ein.</translation>
    </message>
    <message>
        <source>%1: no points to change</source>
        <translation>%1: keine Punkte zu ändern</translation>
    </message>
    <message>
        <source>This is your own attempt: another examiner marks and releases it.</source>
        <translation>Dies ist Ihr eigener Versuch: Eine andere Lehrkraft bewertet ihn und gibt ihn frei.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::MeshForm</name>
    <message>
        <source>Leave out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>What %1 is made of</source>
        <translation>Woraus %1 besteht</translation>
    </message>
    <message>
        <source>Mend: join, turn and close holes up to</source>
        <translation>Ausbessern: verbinden, wenden und Löcher schließen bis</translation>
    </message>
    <message>
        <source>Widest hole that is closed</source>
        <translation>Breitestes Loch, das geschlossen wird</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>wound against itself at %1</source>
        <translation>bei %1 gegen sich selbst gewendet</translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s), the widest of %1 at %2</source>
        <translation>
            <numerusform>%n Lücke von %1 bei %2</numerusform>
            <numerusform>%n Lücken, die breiteste von %1 bei %2</numerusform>
        </translation>
    </message>
    <message>
        <source>An open surface cannot be made of anything: mend it first.</source>
        <translation>Eine offene Oberfläche kann aus nichts bestehen: Erst ausbessern.</translation>
    </message>
    <message>
        <source>the one inside wins</source>
        <translation>gilt der innere</translation>
    </message>
    <message>
        <source>the upper one of this list wins</source>
        <translation>gilt der obere in dieser Liste</translation>
    </message>
    <message>
        <source>Where parts overlap</source>
        <translation>Wo sich Teile überschneiden</translation>
    </message>
    <message>
        <source>Where parts overlap,</source>
        <translation>Wo sich Teile überschneiden,</translation>
    </message>
</context>
<context>
    <name>cusp::ui::NumberBox</name>
    <message>
        <source>%1 does not fit the rest of the exercise. It stays at %2.</source>
        <translation>%1 passt nicht zum Rest der Übung. Es bleibt bei %2.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::NumberField</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>A number is needed here: %1. It stays at %2.</source>
        <translation>Hier gehört eine Zahl hin: %1. Es bleibt bei %2.</translation>
    </message>
    <message>
        <source>“%1” is no number. Possible: %2. It stays at %3.</source>
        <translation>„%1“ ist keine Zahl. Möglich: %2. Es bleibt bei %3.</translation>
    </message>
    <message>
        <source>%1 is outside %2. It stays at %3.</source>
        <translation>%1 liegt außerhalb von %2. Es bleibt bei %3.</translation>
    </message>
    <message>
        <source>Rounded to %1.</source>
        <translation>Auf %1 gerundet.</translation>
    </message>
    <message>
        <source>%1 stands in the exercise, outside %2.</source>
        <translation>In der Übung steht %1, außerhalb von %2.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::OwnHistory</name>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Übung wählen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>All exercises</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>Time and score</source>
        <translation>Zeit und Punkte</translation>
    </message>
    <message>
        <source>No attempt yet</source>
        <translation>Noch kein Versuch</translation>
    </message>
    <message>
        <source>Each attempt you finish stays here, with its report.</source>
        <translation>Jeder beendete Versuch bleibt hier, mit seinem Bericht.</translation>
    </message>
    <message>
        <source>Points by attempt</source>
        <translation>Punkte je Versuch</translation>
    </message>
    <message>
        <source>Own assessment less measured</source>
        <translation>Selbsteinschätzung minus gemessen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>exercise, device</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>No result yet, so there is nothing to draw.</source>
        <translation>Noch kein Ergebnis, also nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Older attempts are not shown: they could not be read.</source>
        <translation>Ältere Versuche sind nicht angezeigt: Sie konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Your attempts could not be read.</source>
        <translation>Ihre Versuche konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The charts are not shown: their attempts could not be read.</source>
        <translation>Die Diagramme sind nicht angezeigt: Ihre Versuche konnten nicht gelesen werden.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PackCard</name>
    <message>
        <source>Appeal pack</source>
        <translation>Einspruchsakte</translation>
    </message>
    <message>
        <source>made %1</source>
        <translation>angelegt %1</translation>
    </message>
    <message>
        <source>Signed by this station, key %1.</source>
        <translation>Von dieser Station signiert, Schlüssel %1.</translation>
    </message>
    <message>
        <source>Signed by the key %1, which these records do not know: compare it with the one on that station’s page.</source>
        <translation>Mit dem Schlüssel %1 signiert, den diese Aufzeichnungen nicht kennen: Vergleichen Sie ihn mit dem auf der Seite jener Station.</translation>
    </message>
    <message>
        <source>This pack was changed after it was made.</source>
        <translation>Diese Akte wurde geändert, nachdem sie angelegt war.</translation>
    </message>
    <message numerus="yes">
        <source>Nothing was changed: %n file(s), and every record of the attempt.</source>
        <translation>
            <numerusform>Nichts wurde geändert: %n Datei und alle Aufzeichnungen des Versuchs.</numerusform>
            <numerusform>Nichts wurde geändert: %n Dateien und alle Aufzeichnungen des Versuchs.</numerusform>
        </translation>
    </message>
    <message>
        <source>Compute the attempt anew</source>
        <translation>Versuch neu berechnen</translation>
    </message>
    <message>
        <source>from its trace, and compare tooth and grade</source>
        <translation>aus seiner Spur, und Zahn und Bewertung vergleichen</translation>
    </message>
    <message>
        <source>Computing the attempt anew</source>
        <translation>Der Versuch wird neu berechnet</translation>
    </message>
    <message>
        <source>The trace does not lead to this result.</source>
        <translation>Die Spur führt nicht zu diesem Ergebnis.</translation>
    </message>
    <message>
        <source>This program cannot compute the attempt anew.</source>
        <translation>Dieses Programm kann den Versuch nicht neu berechnen.</translation>
    </message>
    <message>
        <source>It was drilled with engine %1; this is engine %2. The records hold.</source>
        <translation>Gebohrt wurde mit Rechenkern %1; dies ist Rechenkern %2. Die Aufzeichnungen stimmen.</translation>
    </message>
    <message>
        <source>The trace leads to this tooth and this grade, bit for bit.</source>
        <translation>Die Spur führt zu diesem Zahn und dieser Bewertung, Bit für Bit.</translation>
    </message>
    <message>
        <source>The signature does not belong to this description.</source>
        <translation>Die Signatur gehört nicht zu dieser Beschreibung.</translation>
    </message>
    <message>
        <source>Not as they were signed: %1.</source>
        <translation>Nicht so, wie sie signiert wurden: %1.</translation>
    </message>
    <message>
        <source>Its records cannot be read any more.</source>
        <translation>Ihre Aufzeichnungen sind nicht mehr lesbar.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PartsForm</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Cuboid</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>Ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Halbraum</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Carious lesion</source>
        <translation>Kariöse Läsion</translation>
    </message>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>The first less the others</source>
        <translation>Die erste ohne die anderen</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Shapes of the target</source>
        <translation>Formen des Ziels</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Add a shape</source>
        <translation>Form hinzufügen</translation>
    </message>
    <message>
        <source>Remove the shape</source>
        <translation>Form entfernen</translation>
    </message>
    <message>
        <source>Along the arch</source>
        <translation>Entlang des Zahnbogens</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Joined as</source>
        <translation>Verbunden als</translation>
    </message>
    <message>
        <source>Rounding of the edges</source>
        <translation>Rundung der Kanten</translation>
    </message>
    <message>
        <source>Grown by</source>
        <translation>Vergrößert um</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Other end</source>
        <translation>Anderes Ende</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at the other end</source>
        <translation>Radius am anderen Ende</translation>
    </message>
    <message>
        <source>Place of all shapes</source>
        <translation>Lage aller Formen</translation>
    </message>
    <message>
        <source>Towards buccal</source>
        <translation>Nach bukkal</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PasswordDialog</name>
    <message>
        <source>Change password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>Password until now</source>
        <translation>Bisheriges Passwort</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Neues Passwort, mindestens 8 Zeichen</translation>
    </message>
    <message>
        <source>New password again</source>
        <translation>Neues Passwort noch einmal</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The two new passwords differ.</source>
        <translation>Die beiden neuen Passwörter sind verschieden.</translation>
    </message>
    <message>
        <source>Type them again.</source>
        <translation>Geben Sie sie noch einmal ein.</translation>
    </message>
    <message>
        <source>The password until now is another one.</source>
        <translation>Das bisherige Passwort ist ein anderes.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Changing…</source>
        <translation>Wird geändert …</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PedalPanel</name>
    <message>
        <source>Foot pedal</source>
        <translation>Fußpedal</translation>
    </message>
    <message>
        <source>The pedal drives the handpiece</source>
        <translation>Das Pedal treibt das Handstück an</translation>
    </message>
    <message>
        <source>Which pedal</source>
        <translation>Welches Pedal</translation>
    </message>
    <message>
        <source>This pedal plays keyboard: what it types goes to the window as well. With its maker&apos;s program, set it to a key from F13 to F24.</source>
        <translation>Dieses Pedal spielt Tastatur: Was es tippt, geht auch ans Fenster. Stellen Sie es mit dem Programm des Herstellers auf eine Taste von F13 bis F24.</translation>
    </message>
    <message>
        <source>Pressed</source>
        <translation>Gedrückt</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Drills</source>
        <translation>Bohrt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>No switch for the coolant</source>
        <translation>Kein Schalter für die Kühlung</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Choose the switch for the coolant</source>
        <translation>Schalter für die Kühlung wählen</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>Dead zone at both ends</source>
        <translation>Totbereich an beiden Enden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Press the pedal once, release it, and take the foot off.</source>
        <translation>Treten Sie das Pedal einmal, lassen Sie es los und nehmen Sie den Fuß weg.</translation>
    </message>
    <message>
        <source>Press the switch that runs the coolant.</source>
        <translation>Treten Sie den Schalter, der die Kühlung laufen lässt.</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>The first foot pedal that is found</source>
        <translation>Das erste Fußpedal, das gefunden wird</translation>
    </message>
    <message>
        <source>Nothing yet: calibrate it</source>
        <translation>Noch nichts: bitte kalibrieren</translation>
    </message>
    <message>
        <source>Any switch of it</source>
        <translation>Jeder seiner Schalter</translation>
    </message>
    <message>
        <source>The pedal is not connected any more.</source>
        <translation>Das Pedal ist nicht mehr verbunden.</translation>
    </message>
    <message>
        <source>It is: %1</source>
        <translation>Es ist: %1</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>Noch hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>No foot pedal is connected</source>
        <translation>Kein Fußpedal ist verbunden</translation>
    </message>
    <message>
        <source>%1: no permission</source>
        <translation>%1: keine Berechtigung</translation>
    </message>
    <message>
        <source>%1: not connected</source>
        <translation>%1: nicht verbunden</translation>
    </message>
    <message>
        <source>%1: connected</source>
        <translation>%1: verbunden</translation>
    </message>
    <message>
        <source>%1: connected, not used</source>
        <translation>%1: verbunden, nicht benutzt</translation>
    </message>
    <message>
        <source>Press the pedal all the way down and hold it.</source>
        <translation>Treten Sie das Pedal ganz durch und halten Sie es gedrückt.</translation>
    </message>
    <message>
        <source>Take the foot off the pedal.</source>
        <translation>Nehmen Sie den Fuß vom Pedal.</translation>
    </message>
    <message>
        <source>The pedal is not back where it rested. If the foot is off, the pedal was pressed at the first step: cancel, and calibrate again.</source>
        <translation>Das Pedal steht nicht wieder in seiner Ruhelage. Wenn der Fuß weg ist, war das Pedal beim ersten Schritt gedrückt: Brechen Sie ab und kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The pedal is back where it rested. If it is down, it was pressed at the first step: cancel, and calibrate again.</source>
        <translation>Das Pedal steht wieder in seiner Ruhelage. Wenn es durchgetreten ist, war es beim ersten Schritt gedrückt: Brechen Sie ab und kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 was down at the first step. If the foot was on the pedal, cancel and calibrate again.</source>
        <translation>%1 war beim ersten Schritt gedrückt. Wenn der Fuß auf dem Pedal stand, brechen Sie ab und kalibrieren Sie noch einmal.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PedalText</name>
    <message>
        <source>space bar</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Rudder</source>
        <translation>Seitenruder</translation>
    </message>
    <message>
        <source>Throttle</source>
        <translation>Schubhebel</translation>
    </message>
    <message>
        <source>Accelerator</source>
        <translation>Gaspedal</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Bremse</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>Schalter %1</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Taste %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PeopleImport</name>
    <message>
        <source>Import a list of students</source>
        <translation>Liste von Studierenden importieren</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>CSV with the columns number and name, and if wanted PIN and cohort</source>
        <translation>CSV mit den Spalten Nummer und Name, auf Wunsch PIN und Kohorte</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Make the accounts</source>
        <translation>Konten anlegen</translation>
    </message>
    <message>
        <source>Save the PIN slips</source>
        <translation>PIN-Zettel speichern</translation>
    </message>
    <message>
        <source>Lines of the list</source>
        <translation>Zeilen der Liste</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Choose a list of students</source>
        <translation>Liste von Studierenden wählen</translation>
    </message>
    <message>
        <source>CSV (*.csv *.txt)</source>
        <translation>CSV (*.csv *.txt)</translation>
    </message>
    <message>
        <source>%1 cannot be read.</source>
        <translation>%1 kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>%1 is too large for a list of students.</source>
        <translation>%1 ist zu groß für eine Liste von Studierenden.</translation>
    </message>
    <message>
        <source>4 MB are the most.</source>
        <translation>Höchstens 4 MB.</translation>
    </message>
    <message>
        <source>A quote that opens in line %1 is never closed.</source>
        <translation>Ein Anführungszeichen aus Zeile %1 wird nie geschlossen.</translation>
    </message>
    <message>
        <source>It has no line below the heads of the columns.</source>
        <translation>Unter den Spaltenköpfen steht keine Zeile.</translation>
    </message>
    <message>
        <source>Its first line needs the heads number and name, or number, first name and surname.</source>
        <translation>Die erste Zeile braucht die Köpfe Nummer und Name, oder Nummer, Vorname und Nachname.</translation>
    </message>
    <message>
        <source>%1 is no list of students.</source>
        <translation>%1 ist keine Liste von Studierenden.</translation>
    </message>
    <message numerus="yes">
        <source>%n new account(s).</source>
        <translation>
            <numerusform>%n neues Konto.</numerusform>
            <numerusform>%n neue Konten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) have one already.</source>
        <translation>
            <numerusform>%n hat schon eines.</numerusform>
            <numerusform>%n haben schon eines.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) belong to another name and stay as they are.</source>
        <translation>
            <numerusform>%n Nummer gehört zu einem anderen Namen und bleibt, wie sie ist.</numerusform>
            <numerusform>%n Nummern gehören zu anderen Namen und bleiben, wie sie sind.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) are left out; the table says why.</source>
        <translation>
            <numerusform>%n Zeile wird ausgelassen; die Tabelle zeigt den Grund.</numerusform>
            <numerusform>%n Zeilen werden ausgelassen; die Tabelle zeigt den Grund.</numerusform>
        </translation>
    </message>
    <message>
        <source>Making accounts</source>
        <translation>Konten werden angelegt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The list is imported.</source>
        <translation>Die Liste ist importiert.</translation>
    </message>
    <message>
        <source>Their PINs stand in %1 alone.</source>
        <translation>Ihre PINs stehen allein in %1.</translation>
    </message>
    <message>
        <source>Stopped at line %1.</source>
        <translation>Angehalten in Zeile %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) made.</source>
        <translation>
            <numerusform>%n Konto angelegt.</numerusform>
            <numerusform>%n Konten angelegt.</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Choose another place. No account was made.</source>
        <translation>Wählen Sie einen anderen Ort. Kein Konto wurde angelegt.</translation>
    </message>
    <message>
        <source>PIN slips %1.pdf</source>
        <translation>PIN-Zettel %1.pdf</translation>
    </message>
    <message>
        <source>No list yet</source>
        <translation>Noch keine Liste</translation>
    </message>
    <message>
        <source>Each line becomes an account once you have looked at it here.</source>
        <translation>Jede Zeile wird ein Konto, sobald Sie sie hier angesehen haben.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Switched off, so that nobody signs in with them: %1. Switch them on under People.</source>
        <translation>Ausgeschaltet, sodass sich niemand damit anmeldet: %1. Schalten Sie sie unter „Personen“ ein.</translation>
    </message>
    <message numerus="yes">
        <source>%n new name(s) have an account under another number: perhaps the same person.</source>
        <translation>
            <numerusform>%n neuer Name hat schon ein Konto unter einer anderen Nummer: vielleicht dieselbe Person.</numerusform>
            <numerusform>%n neue Namen haben schon Konten unter anderen Nummern: vielleicht dieselben Personen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No account was made.</source>
        <translation>Es wurde kein Konto angelegt.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PeopleModel</name>
    <message>
        <source>PIN or password</source>
        <translation>PIN oder Passwort</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>number alone</source>
        <translation>nur Nummer</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Konto</translation>
    </message>
    <message>
        <source>Signs in as</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Signs in with</source>
        <translation>Anmeldung</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Kohorte</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PeoplePage</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Find somebody</source>
        <translation>Jemanden finden</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Number or user name</source>
        <translation>Nummer oder Benutzername</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>PIN, six digits</source>
        <translation>PIN, sechs Ziffern</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Switch account off</source>
        <translation>Konto ausschalten</translation>
    </message>
    <message>
        <source>New PIN, six digits</source>
        <translation>Neue PIN, sechs Ziffern</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Neues Passwort, mindestens 8 Zeichen</translation>
    </message>
    <message>
        <source>Password, at least 8 characters</source>
        <translation>Passwort, mindestens 8 Zeichen</translation>
    </message>
    <message>
        <source>Leave it empty to keep the one there is.</source>
        <translation>Leer lassen, um nichts zu ändern.</translation>
    </message>
    <message>
        <source>Without a PIN the number alone signs in.</source>
        <translation>Ohne PIN genügt zum Anmelden die Nummer.</translation>
    </message>
    <message>
        <source>Staff change it themselves under their name at the top.</source>
        <translation>Personal ändert es selbst, oben unter dem eigenen Namen.</translation>
    </message>
    <message>
        <source>Save changes</source>
        <translation>Änderungen speichern</translation>
    </message>
    <message>
        <source>Switch account on</source>
        <translation>Konto einschalten</translation>
    </message>
    <message>
        <source>Name and number are needed.</source>
        <translation>Name und Nummer fehlen.</translation>
    </message>
    <message>
        <source>%1 is added.</source>
        <translation>%1 ist hinzugefügt.</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>%1 can no longer sign in.</source>
        <translation>%1 kann sich nicht mehr anmelden.</translation>
    </message>
    <message>
        <source>%1 can sign in again.</source>
        <translation>%1 kann sich wieder anmelden.</translation>
    </message>
    <message>
        <source>All results are kept.</source>
        <translation>Alle Ergebnisse bleiben aufbewahrt.</translation>
    </message>
    <message>
        <source>Switch off the account of %1?</source>
        <translation>Das Konto von %1 ausschalten?</translation>
    </message>
    <message>
        <source>They can no longer sign in. All results are kept, and you can switch it on again.</source>
        <translation>Eine Anmeldung ist dann nicht mehr möglich. Alle Ergebnisse bleiben aufbewahrt, und Sie können das Konto wieder einschalten.</translation>
    </message>
    <message>
        <source>Import a list</source>
        <translation>Liste importieren</translation>
    </message>
    <message>
        <source>Erase the person</source>
        <translation>Person löschen</translation>
    </message>
    <message>
        <source>Erase %1 for good?</source>
        <translation>%1 endgültig löschen?</translation>
    </message>
    <message>
        <source>Name, number and PIN go, and every text about this person&apos;s attempts. The attempts stay under a pseudonym. It cannot be undone; backups made before still hold the name.</source>
        <translation>Name, Nummer und PIN werden gelöscht, und alle Texte über die Versuche dieser Person. Die Versuche bleiben unter einem Pseudonym. Das lässt sich nicht rückgängig machen; frühere Sicherungen enthalten den Namen noch.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The person is erased.</source>
        <translation>Die Person ist gelöscht.</translation>
    </message>
    <message>
        <source>The attempts stay under a pseudonym.</source>
        <translation>Die Versuche bleiben unter einem Pseudonym.</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Shown roles</source>
        <translation>Gezeigte Rollen</translation>
    </message>
    <message>
        <source>All roles</source>
        <translation>Alle Rollen</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>You change your own password under your name at the top.</source>
        <translation>Ihr eigenes Passwort ändern Sie oben unter Ihrem Namen.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>name, number</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>eine andere Station</translation>
    </message>
    <message>
        <source>Perhaps the same person as %1. This account was made by: %2.</source>
        <translation>Vielleicht dieselbe Person wie %1. Dieses Konto wurde angelegt von: %2.</translation>
    </message>
    <message>
        <source>Perhaps the same person as %1. That account was made by: %2.</source>
        <translation>Vielleicht dieselbe Person wie %1. Jenes Konto wurde angelegt von: %2.</translation>
    </message>
    <message>
        <source>Perhaps the same person as %1: the names agree, and no cohort holds both.</source>
        <translation>Vielleicht dieselbe Person wie %1: Die Namen stimmen überein, und keine Kohorte enthält beide.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Performance</name>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistungen</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>How scores spread</source>
        <translation>Verteilung der Punkte</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernverlauf</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>All dates</source>
        <translation>Gesamter Zeitraum</translation>
    </message>
    <message numerus="yes">
        <source>Last %n day(s)</source>
        <translation>
            <numerusform>Letzter Tag</numerusform>
            <numerusform>Letzte %n Tage</numerusform>
        </translation>
    </message>
    <message>
        <source>Find a student</source>
        <translation>Studierende finden</translation>
    </message>
    <message>
        <source>All exercises</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>All devices</source>
        <translation>Alle Geräte</translation>
    </message>
    <message>
        <source>Median score</source>
        <translation>Median der Punkte</translation>
    </message>
    <message>
        <source>Median time</source>
        <translation>Median der Zeit</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>half lie in %1 to %2</source>
        <translation>die Hälfte liegt in %1 bis %2</translation>
    </message>
    <message>
        <source>95 % interval %1 to %2</source>
        <translation>95-%-Intervall %1 bis %2</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation>Mittlere Hälfte</translation>
    </message>
    <message>
        <source>attempts, five points a bar</source>
        <translation>Versuche, fünf Punkte je Balken</translation>
    </message>
    <message>
        <source>points by attempt</source>
        <translation>Punkte je Versuch</translation>
    </message>
    <message>
        <source>points by attempt, all exercises together</source>
        <translation>Punkte je Versuch, alle Übungen zusammen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>No attempt fits</source>
        <translation>Kein Versuch passt</translation>
    </message>
    <message>
        <source>Nobody has an attempt that fits these filters, or none is finished yet.</source>
        <translation>Niemand hat einen Versuch, der zu diesen Filtern passt, oder noch keiner ist beendet.</translation>
    </message>
    <message>
        <source>Show all attempts</source>
        <translation>Alle Versuche zeigen</translation>
    </message>
    <message>
        <source>Attempts counted</source>
        <translation>Gezählte Versuche</translation>
    </message>
    <message>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s).</source>
        <translation>
            <numerusform>%n Versuch.</numerusform>
            <numerusform>%n Versuche.</numerusform>
        </translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Each dot is one attempt: medians need three students.</source>
        <translation>Jeder Punkt ist ein Versuch: Mediane brauchen drei Studierende.</translation>
    </message>
    <message numerus="yes">
        <source>Median over %n attempt(s).</source>
        <translation>
            <numerusform>Median über %n Versuch.</numerusform>
            <numerusform>Median über %n Versuche.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) exported.</source>
        <translation>
            <numerusform>%n Versuch exportiert.</numerusform>
            <numerusform>%n Versuche exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Too many attempts for another order than the newest first.</source>
        <translation>Zu viele Versuche für eine andere Reihenfolge als die neuesten zuerst.</translation>
    </message>
    <message>
        <source>Up to %1 can be sorted: choose an exercise, a student or a period.</source>
        <translation>Bis zu %1 lassen sich sortieren: wählen Sie eine Übung, eine Person oder einen Zeitraum.</translation>
    </message>
    <message>
        <source>Open an appeal pack</source>
        <translation>Einspruchsakte öffnen</translation>
    </message>
    <message>
        <source>Appeal pack (*.cusppack)</source>
        <translation>Einspruchsakte (*.cusppack)</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>Drilled by</source>
        <translation>Präpariert von</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Studierende</translation>
    </message>
    <message>
        <source>Staff</source>
        <translation>Personal</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Assessments</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>All cohorts</source>
        <translation>Alle Kohorten</translation>
    </message>
    <message>
        <source>All versions</source>
        <translation>Alle Versionen</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Lower end of the middle half</source>
        <translation>Unteres Ende der mittleren Hälfte</translation>
    </message>
    <message>
        <source>Upper end of the middle half</source>
        <translation>Oberes Ende der mittleren Hälfte</translation>
    </message>
    <message numerus="yes">
        <source>Median of %n student(s)</source>
        <translation>
            <numerusform>Median von %n Person</numerusform>
            <numerusform>Median von %n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting attempts</source>
        <translation>Die Versuche werden exportiert</translation>
    </message>
    <message>
        <source>%1 of %2 attempts</source>
        <translation>%1 von %2 Versuchen</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 was not written. What was there before is unchanged.</source>
        <translation>%1 wurde nicht geschrieben. Was vorher da war, ist unverändert.</translation>
    </message>
    <message>
        <source>Attempts of scripted operators are left out. The filter “%1” shows them alone.</source>
        <translation>Versuche automatischer Operateure sind weggelassen. Der Filter „%1“ zeigt nur sie.</translation>
    </message>
    <message>
        <source>Scripted</source>
        <translation>Automatisch</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Older attempts are not shown: they could not be read.</source>
        <translation>Ältere Versuche sind nicht angezeigt: Sie konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The attempts could not be read.</source>
        <translation>Die Versuche konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>No attempt has points yet.</source>
        <translation>Noch kein Versuch hat Punkte.</translation>
    </message>
    <message>
        <source>The attempts of this chart could not be read.</source>
        <translation>Die Versuche dieses Diagramms konnten nicht gelesen werden.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PinSlips</name>
    <message>
        <source>Sign in to Cusp with</source>
        <translation>Anmelden bei Cusp mit</translation>
    </message>
    <message>
        <source>Number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>PIN %1</source>
        <translation>PIN %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PinnedTooth</name>
    <message>
        <source>The tooth after this attempt</source>
        <translation>Der Zahn nach diesem Versuch</translation>
    </message>
    <message>
        <source>This place lies below the surface.</source>
        <translation>Diese Stelle liegt unter der Oberfläche.</translation>
    </message>
    <message>
        <source>The tooth hides this place. Turn it, or choose the row again.</source>
        <translation>Der Zahn verdeckt diese Stelle. Drehen Sie ihn oder wählen Sie die Zeile noch einmal.</translation>
    </message>
    <message>
        <source>The tooth is being drawn</source>
        <translation>Der Zahn wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PlaybackBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>%1×</source>
        <extracomment>Speed of what is watched; %1 is a number such as 0.5.</extracomment>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>The name of a key stands in brackets.</extracomment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PointsForm</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Criterion to add</source>
        <translation>Neues Kriterium</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a criterion</source>
        <translation>Kriterium hinzufügen</translation>
    </message>
    <message>
        <source>Pass mark, of 100</source>
        <translation>Bestehensgrenze, von 100</translation>
    </message>
    <message>
        <source>Bands of %1</source>
        <translation>Stufen von %1</translation>
    </message>
    <message>
        <source>Show what earns the points</source>
        <translation>Zeigen, was die Punkte bringt</translation>
    </message>
    <message>
        <source>Points for %1</source>
        <translation>Punkte für %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Full points: %1</source>
        <translation>Volle Punktzahl: %1</translation>
    </message>
    <message>
        <source>pass %1 of 100, shares of %2</source>
        <translation>Grenze %1, Summe %2</translation>
    </message>
    <message>
        <source>Opening the pulp fails the attempt</source>
        <translation>Pulpa eröffnet: nicht bestanden</translation>
    </message>
    <message>
        <source>Overheating the tooth fails the attempt</source>
        <translation>Zahn überhitzt: nicht bestanden</translation>
    </message>
    <message>
        <source>Bands of depth move with the target’s depth. Those offered for form, box, margin, contact and caries are not all verified.</source>
        <translation>Die Stufen der Tiefe folgen der Tiefe des Ziels. Die für Form, Kasten, Rand, Kontakt und Karies vorgeschlagenen sind nicht alle geprüft.</translation>
    </message>
    <message>
        <source>Measure the operators</source>
        <translation>Operateure messen</translation>
    </message>
    <message>
        <source>Reference, competent and novice cut it at once; their values mark the bands of each criterion</source>
        <translation>Referenz-, geübter und unerfahrener Operateur präparieren die Übung sofort; ihre Werte stehen als Marken an den Stufen jedes Kriteriums</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
    <message>
        <source>Own assessment before the result</source>
        <translation>Selbsteinschätzung vor dem Ergebnis</translation>
    </message>
    <message>
        <source>The student rates each criterion before the result is shown</source>
        <translation>Studierende schätzen jedes Kriterium ein, bevor das Ergebnis gezeigt wird</translation>
    </message>
    <message>
        <source>Stopped: the exercise was changed.</source>
        <translation>Abgebrochen: Die Übung wurde geändert.</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>Messung abbrechen</translation>
    </message>
    <message>
        <source>Damaging a protected part fails the attempt</source>
        <translation>Geschütztes verletzt: nicht bestanden</translation>
    </message>
</context>
<context>
    <name>cusp::ui::PublishSheet</name>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Publish version %1 of %2?</source>
        <translation>Version %1 von %2 veröffentlichen?</translation>
    </message>
    <message>
        <source>Students then drill this version. Earlier results keep the version they were made with.</source>
        <translation>Studierende präparieren dann diese Version. Frühere Ergebnisse behalten die Version, mit der sie entstanden.</translation>
    </message>
    <message>
        <source>Another window has published version %1.</source>
        <translation>Ein anderes Fenster hat Version %1 veröffentlicht.</translation>
    </message>
    <message>
        <source>Students then drill yours. Version %1 stays in the records.</source>
        <translation>Studierende präparieren dann Ihre. Version %1 bleibt in den Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Changed since version %1</source>
        <translation>Geändert seit Version %1</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>No version of it is published now. Students find it as a new exercise.</source>
        <translation>Keine Version davon ist jetzt veröffentlicht. Studierende finden sie als neue Übung.</translation>
    </message>
    <message>
        <source>Nothing.</source>
        <translation>Nichts.</translation>
    </message>
    <message>
        <source>Open assignments of an older version</source>
        <translation>Offene Zuweisungen einer älteren Version</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>due %1</source>
        <translation>fällig %1</translation>
    </message>
    <message>
        <source>no due date</source>
        <translation>ohne Frist</translation>
    </message>
    <message>
        <source>%1: %2, version %3, %4</source>
        <extracomment>%1: a cohort, %2: practice or assessment, %3: number of a version, %4: &quot;due Fri 4 Dec, 17:00&quot;</extracomment>
        <translation>%1: %2, Version %3, %4</translation>
    </message>
    <message>
        <source>An assignment stays with its version. Assign version %1 to those cohorts anew.</source>
        <translation>Eine Zuweisung bleibt bei ihrer Version. Weisen Sie diesen Kohorten Version %1 neu zu.</translation>
    </message>
    <message>
        <source>It was tried out as it is now.</source>
        <translation>Die Übung wurde so ausprobiert, wie sie jetzt ist.</translation>
    </message>
    <message>
        <source>It was not tried out since it was opened or changed.</source>
        <translation>Die Übung wurde nicht ausprobiert, seit sie geöffnet oder geändert wurde.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Try out</source>
        <translation>Probieren</translation>
    </message>
    <message>
        <source>Publish version %1</source>
        <translation>Version %1 veröffentlichen</translation>
    </message>
    <message>
        <source>Publish it without trying it out?</source>
        <translation>Ohne Ausprobieren veröffentlichen?</translation>
    </message>
    <message>
        <source>Nobody has drilled it as it is now. Students would be the first.</source>
        <translation>In dieser Fassung hat sie noch niemand präpariert. Studierende wären die Ersten.</translation>
    </message>
    <message>
        <source>Publish untried</source>
        <translation>Ohne Ausprobieren veröffentlichen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::QuickOpen</name>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Page or exercise</source>
        <translation>Seite oder Übung</translation>
    </message>
    <message>
        <source>Where to</source>
        <translation>Wohin</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>cusp::ui::QuickStart</name>
    <message>
        <source>To the program</source>
        <translation>Zum Programm</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>Schnellstart</translation>
    </message>
    <message>
        <source>Five steps to the first report</source>
        <translation>Fünf Schritte zum ersten Bericht</translation>
    </message>
    <message>
        <source>You find this page again under Help</source>
        <translation>Sie finden diese Seite unter Hilfe wieder</translation>
    </message>
    <message>
        <source>1. Make people</source>
        <translation>1. Personen anlegen</translation>
    </message>
    <message>
        <source>Under People, add students and instructors one by one, or import a list.</source>
        <translation>Legen Sie unter Personen Studierende und Lehrkräfte einzeln an, oder importieren Sie eine Liste.</translation>
    </message>
    <message>
        <source>2. Assign an exercise</source>
        <translation>2. Übung zuweisen</translation>
    </message>
    <message>
        <source>An instructor puts students together under Cohorts and assigns them an exercise.</source>
        <translation>Eine Lehrkraft fasst unter Kohorten Studierende zusammen und weist ihnen eine Übung zu.</translation>
    </message>
    <message>
        <source>3. Drill</source>
        <translation>3. Bohren</translation>
    </message>
    <message>
        <source>A student signs in with number and PIN, starts the exercise and cuts with mouse or device.</source>
        <translation>Studierende melden sich mit Nummer und PIN an, starten die Übung und tragen mit Maus oder Gerät ab.</translation>
    </message>
    <message>
        <source>4. Read the report</source>
        <translation>4. Bericht lesen</translation>
    </message>
    <message>
        <source>Finish ends the attempt; the report shows the points and where each was lost.</source>
        <translation>„Beenden“ schließt den Versuch ab; der Bericht zeigt die Punkte und wo sie verloren gingen.</translation>
    </message>
    <message>
        <source>5. Back up</source>
        <translation>5. Sichern</translation>
    </message>
    <message>
        <source>Under Station, choose a folder on another disk: a backup a day goes there by itself.</source>
        <translation>Wählen Sie unter Station einen Ordner auf einem anderen Datenträger: Dorthin geht von selbst täglich eine Sicherung.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::RecordingsCard</name>
    <message>
        <source>Recordings of practice</source>
        <translation>Aufzeichnungen des Trainings</translation>
    </message>
    <message>
        <source>Thinning takes out what a replay needs. Grade, report and final tooth stay, and verify. Assessments and results that an examiner has stated something about stay whole.</source>
        <translation>Ausdünnen entfernt, was eine Wiedergabe braucht. Bewertung, Bericht und fertiger Zahn bleiben und lassen sich prüfen. Prüfungen und Ergebnisse, zu denen sich jemand geäußert hat, bleiben vollständig.</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Ended so many days ago, or more</source>
        <translation>Vor mindestens so vielen Tagen beendet</translation>
    </message>
    <message>
        <source>Thin recordings</source>
        <translation>Aufzeichnungen ausdünnen</translation>
    </message>
    <message>
        <source>No recording is that old.</source>
        <translation>Keine Aufzeichnung ist so alt.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s), %1</source>
        <translation>
            <numerusform>%n Aufzeichnung, %1</numerusform>
            <numerusform>%n Aufzeichnungen, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Verifying the attempts</source>
        <translation>Die Versuche werden geprüft</translation>
    </message>
    <message>
        <source>Thinning recordings</source>
        <translation>Aufzeichnungen werden ausgedünnt</translation>
    </message>
    <message>
        <source>%1 of %2 attempts</source>
        <translation>%1 von %2 Versuchen</translation>
    </message>
    <message>
        <source>Nothing can be thinned.</source>
        <translation>Es kann nichts ausgedünnt werden.</translation>
    </message>
    <message>
        <source>%1 on the disk are given free. %2 It cannot be undone; backups made before still hold the recordings.</source>
        <translation>%1 auf dem Datenträger werden frei. %2 Das lässt sich nicht rückgängig machen; frühere Sicherungen enthalten die Aufzeichnungen noch.</translation>
    </message>
    <message numerus="yes">
        <source>Thin %n recording(s)?</source>
        <translation>
            <numerusform>%n Aufzeichnung ausdünnen?</numerusform>
            <numerusform>%n Aufzeichnungen ausdünnen?</numerusform>
        </translation>
    </message>
    <message>
        <source>You stopped it; the other recordings are whole.</source>
        <translation>Sie haben angehalten; die übrigen Aufzeichnungen sind vollständig.</translation>
    </message>
    <message>
        <source>No recording was thinned.</source>
        <translation>Keine Aufzeichnung wurde ausgedünnt.</translation>
    </message>
    <message>
        <source>The other recordings are whole.</source>
        <translation>Die übrigen Aufzeichnungen sind vollständig.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ReferencePage</name>
    <message>
        <source>Briefing</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Turn back to the first view</source>
        <translation>Zurück zur ersten Ansicht</translation>
    </message>
    <message>
        <source>Planning the bur’s path</source>
        <translation>Der Weg des Bohrers wird geplant</translation>
    </message>
    <message>
        <source>Growing the tooth: %1</source>
        <translation>Zahn wird erzeugt: %1</translation>
    </message>
    <message>
        <source>Fetching the tooth</source>
        <translation>Zahn wird geladen</translation>
    </message>
    <message>
        <source>Shaping the tooth’s surface</source>
        <translation>Oberfläche des Zahns wird geformt</translation>
    </message>
    <message>
        <source>Growing the other teeth of the jaw</source>
        <translation>Die übrigen Zähne des Kiefers werden erzeugt</translation>
    </message>
    <message>
        <source>Bur %1</source>
        <translation>Bohrer %1</translation>
    </message>
    <message>
        <source>finished; turn the tooth to look at it</source>
        <translation>fertig; zum Betrachten den Zahn drehen</translation>
    </message>
    <message>
        <source>%1; by hand it takes about %2</source>
        <translation>%1; von Hand dauert es etwa %2</translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation>Idealpräparation</translation>
    </message>
    <message>
        <source>Making the ideal preparation</source>
        <translation>Die Idealpräparation entsteht</translation>
    </message>
    <message>
        <source>Ideal preparation: %1</source>
        <translation>Idealpräparation: %1</translation>
    </message>
    <message>
        <source>The tooth while the ideal preparation is cut</source>
        <translation>Der Zahn, während die Idealpräparation entsteht</translation>
    </message>
    <message>
        <source>The ideal preparation plays.</source>
        <translation>Die Idealpräparation läuft.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Report</name>
    <message>
        <source>tissues at %1 of their stiffness</source>
        <translation>Gewebe mit %1 ihrer Steifigkeit</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>%1 of %2 points, pass mark %3</source>
        <translation>%1 von %2 Punkten, Bestehensgrenze %3</translation>
    </message>
    <message>
        <source>Next time</source>
        <translation>Beim nächsten Mal</translation>
    </message>
    <message>
        <source>Every criterion has its full points.</source>
        <translation>Jedes Kriterium hat die volle Punktzahl.</translation>
    </message>
    <message>
        <source>Every marked criterion has its full points.</source>
        <translation>Jedes bewertete Kriterium hat die volle Punktzahl.</translation>
    </message>
    <message>
        <source>No criterion could be marked.</source>
        <translation>Kein Kriterium konnte bewertet werden.</translation>
    </message>
    <message numerus="yes">
        <source>Best before: %1 point(s) on %2; this attempt %3.</source>
        <translation>
            <numerusform>Bester davor: %1 Punkt am %2; dieser Versuch %3.</numerusform>
            <numerusform>Bester davor: %1 Punkte am %2; dieser Versuch %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>on target, within 0.1 mm</source>
        <translation>auf dem Ziel, innerhalb 0,1 mm</translation>
    </message>
    <message>
        <source>Engine %1, marking %2</source>
        <translation>Rechenkern %1, Bewertung %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <extracomment>From one moment of an attempt to another, as &quot;1:12 to 3:05&quot;.</extracomment>
        <translation>%1 bis %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres Mal</numerusform>
            <numerusform>und %n weitere Male</numerusform>
        </translation>
    </message>
    <message>
        <source>Bur %1: %2</source>
        <extracomment>A bur, and when it was used.</extracomment>
        <translation>Bohrer %1: %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>This fails the attempt, whatever its points.</source>
        <translation>Damit ist der Versuch nicht bestanden, wie viele Punkte er auch hat.</translation>
    </message>
    <message>
        <source>The tooth could not be drawn: OpenGL 3.3 did not start (%1).</source>
        <translation>Der Zahn konnte nicht gezeichnet werden: OpenGL 3.3 startete nicht (%1).</translation>
    </message>
    <message>
        <source>The tooth could not be drawn (%1).</source>
        <translation>Der Zahn konnte nicht gezeichnet werden (%1).</translation>
    </message>
    <message>
        <source>%1: this fails the attempt, whatever its points.</source>
        <translation>%1: Damit ist der Versuch nicht bestanden, wie viele Punkte er auch hat.</translation>
    </message>
    <message>
        <source>Nothing of this attempt is kept</source>
        <translation>Von diesem Versuch wird nichts aufbewahrt</translation>
    </message>
    <message>
        <source>%1 · %2, attempt %3</source>
        <translation>%1 · %2, Versuch %3</translation>
    </message>
    <message>
        <source>uncut remainder, 0.5 mm and more</source>
        <translation>nicht entfernt, 0,5 mm und mehr</translation>
    </message>
    <message>
        <source>uncut remainder, 0.3 mm</source>
        <translation>nicht entfernt, 0,3 mm</translation>
    </message>
    <message>
        <source>over-cut, 0.3 mm</source>
        <translation>überpräpariert, 0,3 mm</translation>
    </message>
    <message>
        <source>over-cut, 0.5 mm and more</source>
        <translation>überpräpariert, 0,5 mm und mehr</translation>
    </message>
    <message>
        <source>Bur %1</source>
        <translation>Bohrer %1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>%1 tief</translation>
    </message>
    <message>
        <source>Where points were lost</source>
        <translation>Wo Punkte verloren gingen</translation>
    </message>
    <message>
        <source>Does not count: %1</source>
        <translation>Zählt nicht: %1</translation>
    </message>
    <message>
        <source>Result confirmed</source>
        <translation>Ergebnis bestätigt</translation>
    </message>
    <message>
        <source>Result released</source>
        <translation>Ergebnis freigegeben</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Kandidat/in %1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>%1, its cuts made at once: time, force and heat are not measured</source>
        <translation>%1, auf einmal präpariert: Zeit, Kraft und Wärme sind nicht gemessen</translation>
    </message>
    <message>
        <source>Own assessment: skipped</source>
        <translation>Selbsteinschätzung: übersprungen</translation>
    </message>
    <message numerus="yes">
        <source>Own assessment: %1 of 100 on %n rated criterion(s), measured %2</source>
        <translation>
            <numerusform>Selbsteinschätzung: %1 von 100 bei %n eingeschätzten Kriterium, gemessen %2</numerusform>
            <numerusform>Selbsteinschätzung: %1 von 100 bei %n eingeschätzten Kriterien, gemessen %2</numerusform>
        </translation>
    </message>
    <message>
        <source>A volume from a file</source>
        <translation>Ein Volumen aus einer Datei</translation>
    </message>
    <message>
        <source>Time, force and heat are not measured</source>
        <translation>Zeit, Kraft und Wärme sind nicht gemessen</translation>
    </message>
    <message>
        <source>drawn tooth, seed %1</source>
        <extracomment>A tooth that an assessment drew for one candidate; the number makes it again.</extracomment>
        <translation>geloster Zahn, Startwert %1</translation>
    </message>
    <message>
        <source>Hatched: where the points of each were lost. Numbers and colours as on the first page.</source>
        <translation>Schraffiert: wo die Punkte jeweils verloren gingen. Zahlen und Farben wie auf der ersten Seite.</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>%1 (superseded)</source>
        <translation>%1 (ersetzt)</translation>
    </message>
    <message>
        <source>Each criterion without its full points was changed by hand; the remarks give the reasons.</source>
        <translation>Jedes Kriterium ohne volle Punkte wurde von Hand geändert; die Bemerkungen nennen die Gründe.</translation>
    </message>
    <message>
        <source>This attempt broke off. It is marked as it stands.</source>
        <translation>Dieser Versuch brach ab. Er ist bewertet, wie er ist.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 instead of %3 point(s)</source>
        <translation>
            <numerusform>%1: %2 statt %3 Punkt</numerusform>
            <numerusform>%1: %2 statt %3 Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 instead of %2 point(s), changed by %3: %4</source>
        <extracomment>%1: points that count, %2: measured points, %3: an examiner, %4: the reason.</extracomment>
        <translation>
            <numerusform>%1 statt %2 Punkt, geändert von %3: %4</numerusform>
            <numerusform>%1 statt %2 Punkte, geändert von %3: %4</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 When each bur was used is no longer known.</source>
        <extracomment>%1: the sentence that says when the recording was thinned.</extracomment>
        <translation>%1 Wann jeder Bohrer benutzt wurde, ist nicht mehr bekannt.</translation>
    </message>
    <message>
        <source>This attempt broke off. It is not graded yet; the points show how it stands now.</source>
        <translation>Dieser Versuch brach ab. Er ist noch nicht bewertet; die Punkte zeigen, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>peak force %1</source>
        <translation>höchste Kraft %1</translation>
    </message>
    <message>
        <source>The records of this attempt could not be read</source>
        <translation>Die Daten dieses Versuchs konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>parts of the records could not be read</source>
        <translation>Teile der Daten konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>version %1 of the exercise</source>
        <translation>Version %1 der Übung</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ReportPage</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>It is marked as it stands.</source>
        <translation>Er ist bewertet, wie er ist.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Als PDF speichern</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>As drilled</source>
        <translation>Wie gebohrt</translation>
    </message>
    <message>
        <source>Turn back to the view from above</source>
        <translation>Zurück zur Ansicht von oben</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>of %1 points, pass mark %2</source>
        <translation>von %1 Punkten, Bestehensgrenze %2</translation>
    </message>
    <message>
        <source>Best before</source>
        <translation>Bester davor</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Next time</source>
        <translation>Beim nächsten Mal</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report is saved.</source>
        <translation>Der Bericht ist gespeichert.</translation>
    </message>
    <message>
        <source>The report was not saved.</source>
        <translation>Der Bericht wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>This fails the attempt, whatever its points; the points still stand.</source>
        <translation>Damit ist der Versuch nicht bestanden, wie viele Punkte er auch hat; die Punkte bleiben stehen.</translation>
    </message>
    <message>
        <source>The report is saved without the picture of the tooth.</source>
        <translation>Der Bericht ist ohne das Bild des Zahns gespeichert.</translation>
    </message>
    <message>
        <source>The report is printed without the picture of the tooth.</source>
        <translation>Der Bericht wird ohne das Bild des Zahns gedruckt.</translation>
    </message>
    <message>
        <source>This attempt broke off.</source>
        <translation>Dieser Versuch brach ab.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>this attempt, %1</source>
        <translation>dieser Versuch, %1</translation>
    </message>
    <message>
        <source>not released yet</source>
        <translation>noch nicht freigegeben</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>The appeal pack is saved.</source>
        <translation>Die Einspruchsakte ist gespeichert.</translation>
    </message>
    <message>
        <source>Appeal pack</source>
        <translation>Einspruchsakte</translation>
    </message>
    <message>
        <source>Save records, report and tooth in one file that another station verifies</source>
        <translation>Aufzeichnungen, Bericht und Zahn in einer Datei speichern, die eine andere Station prüft</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>What is written under Marking is not kept yet.</source>
        <translation>Was unter „Bewertung“ geschrieben steht, ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Leave without the comment?</source>
        <translation>Die Seite ohne den Kommentar verlassen?</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>An appeal pack holds one attempt alone.</source>
        <translation>Eine Einspruchsakte enthält nur einen Versuch.</translation>
    </message>
    <message>
        <source>Nothing of this attempt is kept, so it is compared with no other.</source>
        <translation>Von diesem Versuch wird nichts aufbewahrt; er wird mit keinem anderen verglichen.</translation>
    </message>
    <message>
        <source>The report was not printed.</source>
        <translation>Der Bericht wurde nicht gedruckt.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. The attempt and its grade are kept.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Versuch und Bewertung sind aufbewahrt.</translation>
    </message>
    <message>
        <source>The printer takes nothing. The attempt and its grade are kept.</source>
        <translation>Der Drucker nimmt nichts an. Versuch und Bewertung sind aufbewahrt.</translation>
    </message>
    <message>
        <source>Practise it</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>Begins a practice attempt. It does not count for the assessment.</source>
        <translation>Beginnt einen Trainingsversuch. Er zählt nicht für die Prüfung.</translation>
    </message>
    <message>
        <source>No result with this device came before. From the next one on this compares the two.</source>
        <translation>Davor gab es kein Ergebnis mit diesem Gerät. Ab dem nächsten werden hier beide verglichen.</translation>
    </message>
    <message>
        <source>That attempt was marked by other criteria: only the points of the two compare.</source>
        <translation>Jener Versuch wurde nach anderen Kriterien bewertet: Nur die Punkte der beiden sind vergleichbar.</translation>
    </message>
    <message>
        <source>It is not graded yet; the points show how it stands now.</source>
        <translation>Er ist noch nicht bewertet; die Punkte zeigen, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>Cut the tooth open and compare its walls with the ideal preparation</source>
        <translation>Den Zahn aufschneiden und seine Wände mit der Idealpräparation vergleichen</translation>
    </message>
    <message>
        <source>This report is not whole: parts of the records could not be read.</source>
        <translation>Dieser Bericht ist unvollständig: Teile der Daten konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Remarks, changed points or an earlier result may be missing. %1</source>
        <translation>Anmerkungen, geänderte Punkte oder ein früheres Ergebnis fehlen womöglich. %1</translation>
    </message>
    <message>
        <source>It could not be read whether a result came before.</source>
        <translation>Ob es ein früheres Ergebnis gibt, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Leave without the changed points?</source>
        <translation>Die Seite ohne die geänderten Punkte verlassen?</translation>
    </message>
    <message>
        <source>Against the best before</source>
        <translation>Gegen den besten Versuch davor</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ReportSection</name>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Tolerance zone</source>
        <translation>Toleranzzone</translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation>Idealpräparation</translation>
    </message>
</context>
<context>
    <name>cusp::ui::RightsRow</name>
    <message>
        <source>This user may not open it. Paste this line into a terminal once, then plug it in again:</source>
        <translation>Dieses Benutzerkonto darf es nicht öffnen. Fügen Sie diese Zeile einmal in ein Terminal ein und stecken Sie es dann neu an:</translation>
    </message>
    <message>
        <source>Line for the terminal</source>
        <translation>Zeile für das Terminal</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SaveCsv</name>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>The file was not written.</source>
        <translation>Die Datei wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>%1: %2. What was there before is unchanged.</source>
        <translation>%1: %2. Was vorher da war, ist unverändert.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ScorePanel</name>
    <message>
        <source>Section at the bur</source>
        <translation>Schnitt am Bohrer</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Target removed</source>
        <translation>Ziel abgetragen</translation>
    </message>
    <message>
        <source>of the target removed</source>
        <translation>des Ziels abgetragen</translation>
    </message>
    <message>
        <source>Least dentine over pulp</source>
        <translation>Dentin über Pulpa, min.</translation>
    </message>
    <message>
        <source>Removed so far</source>
        <translation>Bisher abgetragen</translation>
    </message>
    <message>
        <source>All tissues feel softer, at %1 of their stiffness: with more this device could begin to tremble.</source>
        <translation>Alle Gewebe fühlen sich weicher an, mit %1 ihrer Steifigkeit: mit mehr könnte dieses Gerät zu zittern beginnen.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>buccal–lingual</source>
        <translation>bukkal–lingual</translation>
    </message>
    <message>
        <source>buccal–palatal</source>
        <translation>bukkal–palatinal</translation>
    </message>
    <message>
        <source>across</source>
        <translation>quer</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>enough</source>
        <translation>genug</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>langsam</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Over-cut</source>
        <translation>Überpräpariert</translation>
    </message>
    <message>
        <source>Your task</source>
        <translation>Die Aufgabe</translation>
    </message>
    <message>
        <source>The foot pedal is not plugged in any more. Until it is, the button alone cuts.</source>
        <translation>Das Fußpedal ist nicht mehr angeschlossen. Bis es wieder angeschlossen ist, trägt der Bohrer nur auf Tastendruck ab.</translation>
    </message>
    <message>
        <source>The foot pedal is plugged in again.</source>
        <translation>Das Fußpedal ist wieder angeschlossen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Mesiodistal</source>
        <translation>Mesiodistal</translation>
    </message>
    <message>
        <source>Buccolingual</source>
        <translation>Bukkolingual</translation>
    </message>
    <message>
        <source>Way of the section</source>
        <translation>Richtung des Schnitts</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Ort des Schnitts</translation>
    </message>
    <message>
        <source>Lengthwise</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>Crosswise</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>palatal</source>
        <translation>palatinal</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>lingual</translation>
    </message>
    <message>
        <source>mesial</source>
        <translation>mesial</translation>
    </message>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>bukkal</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>Where a section goes; %1 is a length, %2 a side of the tooth.</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Through the middle</source>
        <translation>Durch die Mitte</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SectionView</name>
    <message>
        <source>Section at the bur</source>
        <translation>Schnitt am Bohrer</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SelfAssessmentPage</name>
    <message>
        <source>Own assessment</source>
        <translation>Selbsteinschätzung</translation>
    </message>
    <message>
        <source>How did it go?</source>
        <translation>Wie ist es gelungen?</translation>
    </message>
    <message>
        <source>Rate each criterion before you see what was measured. It earns and costs no points.</source>
        <translation>Schätzen Sie jedes Kriterium ein, bevor Sie sehen, was gemessen wurde. Das bringt und kostet keine Punkte.</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Full points: %1</source>
        <translation>Volle Punktzahl: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>The records then say that you rated nothing</source>
        <translation>Die Aufzeichnungen halten dann fest, dass Sie nichts eingeschätzt haben</translation>
    </message>
    <message>
        <source>Show the result</source>
        <translation>Ergebnis zeigen</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>%1 of %2 rated. Keys 1, 2 and 3 rate a row and go on.</source>
        <extracomment>Of an own assessment: %1 of %2 criteria have a rating.</extracomment>
        <translation>%1 von %2 eingeschätzt. Die Tasten 1, 2 und 3 schätzen eine Zeile ein und gehen weiter.</translation>
    </message>
    <message>
        <source>Go on without it</source>
        <translation>Ohne sie weiter</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SessionFoot</name>
    <message>
        <source>The picture is %1 behind the bur. Lift the bur and wait.</source>
        <translation>Das Bild ist %1 hinter dem Bohrer zurück. Bohrer abheben und warten.</translation>
    </message>
    <message>
        <source>The record cannot be written</source>
        <translation>Die Aufzeichnung kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>This computer is too slow. Lift the bur and wait, or the attempt ends.</source>
        <translation>Dieser Rechner ist zu langsam. Bohrer abheben und warten, sonst endet der Versuch.</translation>
    </message>
    <message>
        <source>Recording, not yet written to the disk</source>
        <translation>Aufzeichnung, noch nicht auf den Datenträger geschrieben</translation>
    </message>
    <message>
        <source>Recording, saved every second</source>
        <translation>Aufzeichnung, jede Sekunde gespeichert</translation>
    </message>
    <message>
        <source>Nothing is kept</source>
        <translation>Nichts wird aufbewahrt</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ShapeForm</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Fissure outline</source>
        <translation>Fissurenverlauf</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kasten</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Measured from height</source>
        <translation>Gemessen ab Höhe</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Along the arch</source>
        <translation>Entlang des Zahnbogens</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>Add a branch</source>
        <translation>Ast hinzufügen</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Strictness</source>
        <translation>Strenge</translation>
    </message>
    <message>
        <source>Beginner</source>
        <translation>Einstieg</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Linie %1, %2</translation>
    </message>
    <message>
        <source>Tolerance zone, floor</source>
        <translation>Toleranzzone, Boden</translation>
    </message>
    <message>
        <source>Tolerance zone, sides</source>
        <translation>Toleranzzone, Seiten</translation>
    </message>
    <message>
        <source>Composed shape</source>
        <translation>Zusammengesetzte Form</translation>
    </message>
    <message>
        <source>Some faces have a tolerance zone of their own; it stays as it is.</source>
        <translation>Einige Flächen haben eine eigene Toleranzzone; sie bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Lean, %1</source>
        <translation>Neigung, %1</translation>
    </message>
    <message>
        <source>Lean, back along the arch</source>
        <translation>Neigung, Zahnbogen rückwärts</translation>
    </message>
    <message>
        <source>Lean, on along the arch</source>
        <translation>Neigung, Zahnbogen vorwärts</translation>
    </message>
    <message>
        <source>Above 0 the wall opens upwards</source>
        <translation>Über 0 öffnet sich die Wand nach oben</translation>
    </message>
    <message>
        <source>Lean, towards lingual</source>
        <translation>Neigung, nach lingual</translation>
    </message>
    <message>
        <source>Lean, towards buccal</source>
        <translation>Neigung, nach bukkal</translation>
    </message>
    <message>
        <source>Towards buccal</source>
        <translation>Nach bukkal</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Shell</name>
    <message>
        <source>Top bar</source>
        <translation>Kopfleiste</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Account of %1</source>
        <translation>Konto von %1</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Größe von allem</translation>
    </message>
    <message>
        <source>Change password…</source>
        <translation>Passwort ändern …</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>In the left hand</source>
        <translation>In der linken Hand</translation>
    </message>
    <message>
        <source>In the right hand</source>
        <translation>In der rechten Hand</translation>
    </message>
    <message>
        <source>Exercises in</source>
        <translation>Übungen auf</translation>
    </message>
    <message>
        <source>As the program</source>
        <translation>Wie das Programm</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SignIn</name>
    <message>
        <source>First start</source>
        <translation>Erster Start</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>%1: results are kept on this computer, in %2.</source>
        <translation>%1: Ergebnisse bleiben auf diesem Rechner, in %2.</translation>
    </message>
    <message>
        <source>A tooth</source>
        <translation>Ein Zahn</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Student/in</translation>
    </message>
    <message>
        <source>Staff</source>
        <translation>Personal</translation>
    </message>
    <message>
        <source>Student number</source>
        <translation>Matrikelnummer</translation>
    </message>
    <message>
        <source>PIN, six digits</source>
        <translation>PIN, sechs Ziffern</translation>
    </message>
    <message>
        <source>User name</source>
        <translation>Benutzername</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>No account. You drill a practice block with the mouse; nothing goes into the school’s records.</source>
        <translation>Ohne Konto. Sie bohren mit der Maus an einem Übungsblock; nichts kommt in die Aufzeichnungen der Schule.</translation>
    </message>
    <message>
        <source>Nobody manages this computer’s records yet. Make the administrator; everybody else is added afterwards.</source>
        <translation>Noch verwaltet niemand die Aufzeichnungen dieses Rechners. Legen Sie die Verwaltung an; alle anderen kommen danach dazu.</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Password, at least 8 characters</source>
        <translation>Passwort, mindestens 8 Zeichen</translation>
    </message>
    <message>
        <source>Password again</source>
        <translation>Passwort noch einmal</translation>
    </message>
    <message>
        <source>Make the administrator</source>
        <translation>Verwaltung anlegen</translation>
    </message>
    <message>
        <source>The user name is missing.</source>
        <translation>Der Benutzername fehlt.</translation>
    </message>
    <message>
        <source>The student number is missing.</source>
        <translation>Die Matrikelnummer fehlt.</translation>
    </message>
    <message>
        <source>The PIN has six digits.</source>
        <translation>Die PIN hat sechs Ziffern.</translation>
    </message>
    <message>
        <source>Name and user name are needed.</source>
        <translation>Name und Benutzername fehlen.</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>Die beiden Passwörter sind verschieden.</translation>
    </message>
    <message>
        <source>Type them again.</source>
        <translation>Geben Sie sie noch einmal ein.</translation>
    </message>
    <message>
        <source>The PIN is missing.</source>
        <translation>Die PIN fehlt.</translation>
    </message>
    <message>
        <source>It has six digits.</source>
        <translation>Sie hat sechs Ziffern.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Go back to a backup</source>
        <translation>Zu einer Sicherung zurück</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SizePicture</name>
    <message>
        <source>Size beside a molar</source>
        <translation>Größe neben einem Molaren</translation>
    </message>
    <message>
        <source>%1, beside a lower first molar of %2</source>
        <translation>%1, neben einem unteren ersten Molaren von %2</translation>
    </message>
    <message>
        <source>molar</source>
        <translation>Molar</translation>
    </message>
    <message>
        <source>your file</source>
        <translation>Ihre Datei</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SliceView</name>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SpaceMousePanel</name>
    <message>
        <source>The SpaceMouse leads the view of the tooth</source>
        <translation>Die SpaceMouse führt die Ansicht des Zahns</translation>
    </message>
    <message>
        <source>Its left button brings the first view back, its right one puts in the mirror or takes it out.</source>
        <translation>Ihre linke Taste bringt die erste Ansicht zurück, ihre rechte setzt den Spiegel ein oder nimmt ihn heraus.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation>Näher</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Move and zoom</source>
        <translation>Verschieben und zoomen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totbereich</translation>
    </message>
    <message>
        <source>Hand is off: take this as rest</source>
        <translation>Hand ist weg: dies als Ruhelage nehmen</translation>
    </message>
    <message>
        <source>Taken over</source>
        <translation>Übernommen</translation>
    </message>
    <message>
        <source>Take the hand off first</source>
        <translation>Nehmen Sie zuerst die Hand weg</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Battery %1</source>
        <translation>Akku %1</translation>
    </message>
    <message>
        <source>No SpaceMouse is connected</source>
        <translation>Keine SpaceMouse ist verbunden</translation>
    </message>
    <message>
        <source>%1: no permission</source>
        <translation>%1: keine Berechtigung</translation>
    </message>
    <message>
        <source>%1: not connected</source>
        <translation>%1: nicht verbunden</translation>
    </message>
    <message>
        <source>%1: connected</source>
        <translation>%1: verbunden</translation>
    </message>
    <message>
        <source>%1: connected, not used</source>
        <translation>%1: verbunden, nicht benutzt</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SparingRecords</name>
    <message>
        <source>%1 belongs to the records.</source>
        <translation>%1 gehört zu den Aufzeichnungen.</translation>
    </message>
    <message>
        <source>A file of that name would take the place of one of theirs. Nothing was written.</source>
        <translation>Eine Datei dieses Namens würde eine davon ersetzen. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Anderen Namen wählen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::SpecimenForm</name>
    <message>
        <source>%1, upper right</source>
        <translation>%1, oben rechts</translation>
    </message>
    <message>
        <source>%1, upper left</source>
        <translation>%1, oben links</translation>
    </message>
    <message>
        <source>%1, lower left</source>
        <translation>%1, unten links</translation>
    </message>
    <message>
        <source>%1, lower right</source>
        <translation>%1, unten rechts</translation>
    </message>
    <message>
        <source>Practice block</source>
        <translation>Übungsblock</translation>
    </message>
    <message>
        <source>Block of two materials</source>
        <translation>Block aus zwei Materialien</translation>
    </message>
    <message>
        <source>Block of three materials</source>
        <translation>Block aus drei Materialien</translation>
    </message>
    <message>
        <source>Change the tooth</source>
        <translation>Zahn ändern</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>average</source>
        <translation>Durchschnitt</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Choose a volume…</source>
        <translation>Volumen wählen …</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>No file chosen yet.</source>
        <translation>Noch keine Datei gewählt.</translation>
    </message>
    <message>
        <source>The fineness of this volume is %1; an exercise takes %2 to %3.</source>
        <translation>Die Feinheit dieses Volumens ist %1; eine Übung nimmt %2 bis %3.</translation>
    </message>
    <message>
        <source>Nothing was changed. The import in the library makes it coarser or finer.</source>
        <translation>Nichts wurde geändert. Der Import in der Bibliothek macht es gröber oder feiner.</translation>
    </message>
    <message>
        <source>This tooth cannot be used.</source>
        <translation>Dieser Zahn ist nicht verwendbar.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Choose a volume</source>
        <translation>Volumen wählen</translation>
    </message>
    <message>
        <source>Volumes (*.nrrd)</source>
        <translation>Volumen (*.nrrd)</translation>
    </message>
    <message>
        <source>Another number grows another tooth of its kind; 0 is the average</source>
        <translation>Eine andere Zahl erzeugt einen anderen Zahn dieser Art; 0 ist der Durchschnitt</translation>
    </message>
    <message>
        <source>Nothing was changed. Make it anew from its scan or its surfaces.</source>
        <translation>Nichts wurde geändert. Erstellen Sie es neu aus seinem Scan oder seinen Oberflächen.</translation>
    </message>
    <message>
        <source>%1 of %2 lie on the new volume. Keep them if it shows the same tooth in the same place.</source>
        <extracomment>%1, %2: numbers of landmarks</extracomment>
        <translation>%1 von %2 liegen auf dem neuen Volumen. Behalten Sie sie, wenn es denselben Zahn am selben Ort zeigt.</translation>
    </message>
    <message>
        <source>Keep the landmarks?</source>
        <translation>Landmarken behalten?</translation>
    </message>
    <message>
        <source>Keep them</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Weglassen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::StartPage</name>
    <message>
        <source>Due next</source>
        <translation>Als Nächstes fällig</translation>
    </message>
    <message>
        <source>Your practice</source>
        <translation>Ihr Training</translation>
    </message>
    <message>
        <source>No exercise yet</source>
        <translation>Noch keine Übung</translation>
    </message>
    <message>
        <source>Next exercise</source>
        <translation>Nächste Übung</translation>
    </message>
    <message>
        <source>The tooth with its target</source>
        <translation>Der Zahn mit seinem Ziel</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Als Nächstes</translation>
    </message>
    <message>
        <source>Next, due %1</source>
        <translation>Als Nächstes, fällig %1</translation>
    </message>
    <message>
        <source>%1 of %2 used</source>
        <translation>%1 von %2 genutzt</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Bestwert</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keiner</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Enter starts</source>
        <translation>Enter startet</translation>
    </message>
    <message>
        <source>Your exercises</source>
        <translation>Ihre Übungen</translation>
    </message>
    <message>
        <source>Last result</source>
        <translation>Letztes Ergebnis</translation>
    </message>
    <message>
        <source>No result yet</source>
        <translation>Noch kein Ergebnis</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>von 100</translation>
    </message>
    <message>
        <source>%1 more than
your best before</source>
        <translation>%1 mehr als
Ihr bester davor</translation>
    </message>
    <message>
        <source>the same as
your best before</source>
        <translation>so viel wie
Ihr bester davor</translation>
    </message>
    <message>
        <source>%1 less than
your best before</source>
        <translation>%1 weniger als
Ihr bester davor</translation>
    </message>
    <message>
        <source>What to do next time</source>
        <translation>Was beim nächsten Mal zu tun ist</translation>
    </message>
    <message>
        <source>Nothing: every criterion has its full points.</source>
        <translation>Nichts: jedes Kriterium hat die volle Punktzahl.</translation>
    </message>
    <message>
        <source>Not every criterion has its full points: see the report.</source>
        <translation>Nicht jedes Kriterium hat die volle Punktzahl: siehe Bericht.</translation>
    </message>
    <message>
        <source>The report has the points of each criterion.</source>
        <translation>Der Bericht enthält die Punkte jedes Kriteriums.</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Time and score</source>
        <translation>Zeit und Punkte</translation>
    </message>
    <message>
        <source>Nothing to draw yet</source>
        <translation>Noch nichts zu zeichnen</translation>
    </message>
    <message>
        <source>Every attempt is kept, also one that broke off.</source>
        <translation>Jeder Versuch wird aufbewahrt, auch ein unterbrochener.</translation>
    </message>
    <message>
        <source>This station has no exercise that can be read. Ask your instructor.</source>
        <translation>Diese Station hat keine lesbare Übung. Fragen Sie Ihre Lehrkraft.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>After the first attempt its points and what to do next time stand here.</source>
        <translation>Nach dem ersten Versuch stehen hier seine Punkte und was beim nächsten Mal zu tun ist.</translation>
    </message>
    <message>
        <source>Each attempt becomes one point.</source>
        <translation>Jeder Versuch wird als Punkt eingezeichnet.</translation>
    </message>
    <message numerus="yes">
        <source>Time earns no points. %1 only, %n attempt(s).</source>
        <translation>
            <numerusform>Zeit bringt keine Punkte. Gerät: %1, %n Versuch.</numerusform>
            <numerusform>Zeit bringt keine Punkte. Gerät: %1, %n Versuche.</numerusform>
        </translation>
    </message>
    <message>
        <source>From your instructor</source>
        <translation>Von Ihrer Lehrkraft</translation>
    </message>
    <message>
        <source>on your attempt of %1</source>
        <translation>zu Ihrem Versuch vom %1</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Lehrkraft</translation>
    </message>
    <message>
        <source>An examiner changed the points; the remarks in the report give the reasons.</source>
        <translation>Eine Lehrkraft hat die Punkte geändert; die Bemerkungen im Bericht nennen die Gründe.</translation>
    </message>
    <message numerus="yes">
        <source>%1 only, %n attempt(s).</source>
        <translation>
            <numerusform>Gerät: %1, %n Versuch.</numerusform>
            <numerusform>Gerät: %1, %n Versuche.</numerusform>
        </translation>
    </message>
    <message>
        <source>Your assessments could not be read.</source>
        <translation>Ihre Prüfungen konnten nicht gelesen werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n assessment(s) cannot be shown.</source>
        <translation>
            <numerusform>%n Prüfung kann nicht angezeigt werden.</numerusform>
            <numerusform>%n Prüfungen können nicht angezeigt werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>This station cannot read the exercise. Ask the invigilator.</source>
        <translation>Diese Station kann die Übung nicht lesen. Fragen Sie die Aufsicht.</translation>
    </message>
    <message>
        <source>An interrupted attempt could not be read.</source>
        <translation>Ein unterbrochener Versuch konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The newest comment could not be read.</source>
        <translation>Der neueste Kommentar konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::StationPage</name>
    <message>
        <source>The folder holds until Cusp is closed.</source>
        <translation>Der Ordner gilt, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know the folder.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start den Ordner nicht.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Datenbestand</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s), %1</source>
        <translation>
            <numerusform>%n Versuch, %1</numerusform>
            <numerusform>%n Versuche, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Verification proves that nobody but the program has changed a result, an account or the log.</source>
        <translation>Die Prüfung beweist, dass nur das Programm Ergebnisse, Konten und Protokoll geändert hat.</translation>
    </message>
    <message>
        <source>Verify now</source>
        <translation>Jetzt prüfen</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>To go back, restore a backup to a new database with &quot;cusp restore FOLDER NEW.db&quot;. Nothing is overwritten.</source>
        <translation>Um zurückzugehen, stellen Sie eine Sicherung mit „cusp restore ORDNER NEU.db“ als neue Datenbank wieder her. Nichts wird überschrieben.</translation>
    </message>
    <message>
        <source>There is no backup yet.</source>
        <translation>Es gibt noch keine Sicherung.</translation>
    </message>
    <message>
        <source>The newest one is of %1.</source>
        <translation>Die neueste ist von %1.</translation>
    </message>
    <message>
        <source>Copying the records</source>
        <translation>Der Datenbestand wird kopiert</translation>
    </message>
    <message>
        <source>No backup was made.</source>
        <translation>Es wurde keine Sicherung erstellt.</translation>
    </message>
    <message>
        <source>The backup is made and checked.</source>
        <translation>Die Sicherung ist erstellt und geprüft.</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s), %1.</source>
        <translation>
            <numerusform>%n Versuch, %1.</numerusform>
            <numerusform>%n Versuche, %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a folder for backups</source>
        <translation>Ordner für Sicherungen wählen</translation>
    </message>
    <message>
        <source>Verifying every record</source>
        <translation>Der ganze Datenbestand wird geprüft</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) and the audit log are whole.</source>
        <translation>
            <numerusform>%n Versuch und das Protokoll sind unversehrt.</numerusform>
            <numerusform>%n Versuche und das Protokoll sind unversehrt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s): something was changed from outside.</source>
        <translation>
            <numerusform>%n Fund: etwas wurde von außen geändert.</numerusform>
            <numerusform>%n Funde: etwas wurde von außen geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Schlüssel %1</translation>
    </message>
    <message>
        <source>Signs this station’s records and appeal packs</source>
        <translation>Signiert den Datenbestand und die Einspruchsakten dieser Station</translation>
    </message>
    <message>
        <source>Signing out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>After so many minutes without input</source>
        <translation>Nach so vielen Minuten ohne Eingabe</translation>
    </message>
    <message>
        <source>Nobody is signed out while drilling. It holds from the next sign-in.</source>
        <translation>Niemand wird beim Bohren abgemeldet. Es gilt ab der nächsten Anmeldung.</translation>
    </message>
    <message>
        <source>The backup is made and checked. An old one could not be removed.</source>
        <translation>Die Sicherung ist erstellt und geprüft. Eine alte ließ sich nicht entfernen.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>The minutes hold until Cusp is closed.</source>
        <translation>Die Minuten gelten, bis Cusp geschlossen wird.</translation>
    </message>
    <message>
        <source>%1 cannot be written, so the next start does not know them.</source>
        <translation>%1 kann nicht geschrieben werden, darum kennt der nächste Start sie nicht.</translation>
    </message>
    <message>
        <source>Copied %1 of %2</source>
        <translation>%1 von %2 kopiert</translation>
    </message>
    <message>
        <source>The backup was stopped.</source>
        <translation>Die Sicherung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>No backup was made, and the records are unchanged.</source>
        <translation>Es wurde keine Sicherung angelegt, und der Datenbestand ist unverändert.</translation>
    </message>
    <message>
        <source>Verified %1 of %2 attempts</source>
        <translation>%1 von %2 Versuchen geprüft</translation>
    </message>
    <message>
        <source>The verification was stopped.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Attempts verified and whole: %1. The others were not verified.</source>
        <translation>Geprüft und unversehrt: %1 (Versuche). Die übrigen wurden nicht geprüft.</translation>
    </message>
    <message>
        <source>You stopped it; the other attempts were not verified.</source>
        <translation>Sie haben abgebrochen; die übrigen Versuche wurden nicht geprüft.</translation>
    </message>
    <message>
        <source>How much the records hold could not be read.</source>
        <translation>Wie viel der Datenbestand enthält, ließ sich nicht lesen.</translation>
    </message>
    <message>
        <source>One a day. The newest %1 of these, and as many of your own, are kept in %2</source>
        <translation>Eine am Tag. Die neuesten %1 davon und ebenso viele eigene bleiben in %2</translation>
    </message>
    <message>
        <source>The folder cannot be read: %1.</source>
        <translation>Der Ordner kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>The folder is being read.</source>
        <translation>Der Ordner wird gelesen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::StationsModel</name>
    <message>
        <source>Station %1</source>
        <translation>Station %1</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>file %1, %2</source>
        <translation>Datei %1, %2</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Known as</source>
        <translation>Bekannt als</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Last file read in</source>
        <translation>Zuletzt eingelesen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::StopCard</name>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The clock stands still. P resumes.</source>
        <translation>Die Uhr steht. P setzt fort.</translation>
    </message>
    <message>
        <source>The device does not answer</source>
        <translation>Das Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>The device answers again</source>
        <translation>Das Gerät antwortet wieder</translation>
    </message>
    <message>
        <source>The driver of the device stands still</source>
        <translation>Der Treiber des Geräts steht still</translation>
    </message>
    <message>
        <source>Unplug the device and plug it in again. What was drilled until then is kept.</source>
        <translation>Gerät ausstecken und wieder anschließen. Was bis dahin abgetragen wurde, bleibt erhalten.</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Take the handpiece, then resume.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Das Handstück nehmen, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The record cannot be written</source>
        <translation>Die Aufzeichnung kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>This computer is too slow for the exercise</source>
        <translation>Dieser Rechner ist zu langsam für die Übung</translation>
    </message>
    <message>
        <source>The attempt ends here and is measured as it stands.</source>
        <translation>Der Versuch endet hier und wird vermessen, wie er ist.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Free some space for %1.</source>
        <translation>Schaffen Sie Speicherplatz für %1.</translation>
    </message>
    <message>
        <source>Your quota is used up: free some space for %1.</source>
        <translation>Ihr Speicherkontingent ist erschöpft: Schaffen Sie Platz für %1.</translation>
    </message>
    <message>
        <source>Close the program that holds %1.</source>
        <translation>Schließen Sie das Programm, das %1 belegt.</translation>
    </message>
    <message>
        <source>Make %1 and its folder writable again.</source>
        <translation>Machen Sie %1 und den Ordner wieder beschreibbar.</translation>
    </message>
    <message>
        <source>Remove the cause at %1.</source>
        <translation>Beheben Sie die Ursache bei %1.</translation>
    </message>
    <message>
        <source>Remove the cause at %1: %2.</source>
        <translation>Beheben Sie die Ursache bei %1: %2.</translation>
    </message>
    <message>
        <source>%1 What you drilled so far is kept while this window stays open. Resume then writes it and goes on.</source>
        <translation>%1 Was bisher abgetragen wurde, bleibt erhalten, solange dieses Fenster offen ist. Fortsetzen schreibt es dann und macht weiter.</translation>
    </message>
    <message>
        <source>%1 What you drilled is kept while this window stays open. Try again then writes it and measures the tooth.</source>
        <translation>%1 Was abgetragen wurde, bleibt erhalten, solange dieses Fenster offen ist. Noch einmal versuchen schreibt es dann und vermisst den Zahn.</translation>
    </message>
    <message>
        <source>The tooth cannot be drawn any more</source>
        <translation>Der Zahn kann nicht mehr gezeichnet werden</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Leave, and start Cusp anew: an attempt that is kept then goes on from here.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Verlassen Sie den Versuch und starten Sie Cusp neu: Ein Versuch, der aufbewahrt wird, geht dann von hier aus weiter.</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Plug it in again where it was, then resume.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Am selben Anschluss wieder anschließen, dann fortsetzen.</translation>
    </message>
    <message>
        <source>Plug in the same Falcon: it has no serial number of its own, and another one at its USB port would be taken for it.</source>
        <translation>Schließen Sie denselben Falcon an: Er hat keine eigene Seriennummer, und ein anderer an seinem USB-Anschluss würde für ihn gehalten.</translation>
    </message>
    <message>
        <source>The handle of the device does not answer</source>
        <translation>Der Griff des Geräts antwortet nicht</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Switch the handle on again, then resume.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Den Griff wieder einschalten, dann fortsetzen.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::StudentListModel</name>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>has an account</source>
        <translation>hat ein Konto</translation>
    </message>
    <message>
        <source>number has another name</source>
        <translation>Nummer hat anderen Namen</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Nummer</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>kein Name</translation>
    </message>
    <message>
        <source>number stands above too</source>
        <translation>Nummer steht schon weiter oben</translation>
    </message>
    <message>
        <source>PIN is not six digits</source>
        <translation>PIN hat nicht sechs Ziffern</translation>
    </message>
    <message>
        <source>number is a member of staff</source>
        <translation>Nummer gehört zum Personal</translation>
    </message>
    <message>
        <source>made here</source>
        <translation>hier vergeben</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>aus der Datei</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Konto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>too long for an account</source>
        <translation>zu lang für ein Konto</translation>
    </message>
    <message>
        <source>has an account, switched off</source>
        <translation>hat ein Konto, ausgeschaltet</translation>
    </message>
    <message>
        <source>name has number %1</source>
        <translation>Name hat Nummer %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TargetNameForm</name>
    <message>
        <source>graded with the whole target</source>
        <translation>wird mit dem ganzen Ziel bewertet</translation>
    </message>
    <message>
        <source>A shape with a name is a target of its own: criteria can ask for its depth, walls and over-cut alone.</source>
        <translation>Eine Form mit Namen ist ein eigenes Ziel: Kriterien können Tiefe, Wände und Überpräpariertes an ihr allein bewerten.</translation>
    </message>
    <message>
        <source>Name as a target of its own</source>
        <translation>Name als eigenes Ziel</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TargetView</name>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Cut out</source>
        <translation>Präpariert</translation>
    </message>
    <message>
        <source>Show the tooth as it is when the target is met</source>
        <translation>Den Zahn zeigen, wie er ist, wenn das Ziel erreicht ist</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Drag a handle, or move it with the arrow keys; Shift moves by 0.01 mm. Drag elsewhere to turn.</source>
        <translation>Einen Griff ziehen oder mit den Pfeiltasten bewegen; Umschalt bewegt um 0,01 mm. Daneben ziehen dreht.</translation>
    </message>
    <message>
        <source>Middle of the box</source>
        <translation>Mitte des Kastens</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>%1 across, %2 along</source>
        <translation>%1 quer, %2 längs</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 breit</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>%1 tief</translation>
    </message>
    <message>
        <source>Tolerance zone</source>
        <translation>Toleranzzone</translation>
    </message>
    <message>
        <source>Cut the tooth open and move the section through it</source>
        <translation>Den Zahn aufschneiden und den Schnitt durch ihn bewegen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>%1 across, %2 along, %3 high</source>
        <translation>%1 quer, %2 längs, %3 hoch</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Other end</source>
        <translation>Anderes Ende</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at the other end</source>
        <translation>Radius am anderen Ende</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: a landmark (&quot;Long axis&quot;), %2: one of its points (&quot;Occlusal end&quot;)</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a place, or the name of a landmark, %2: &quot;proposed&quot; or &quot;set&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Proposed landmark</source>
        <translation>Landmarke, vorgeschlagen</translation>
    </message>
    <message>
        <source>Set landmark</source>
        <translation>Landmarke, gesetzt</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <extracomment>%1: a place in millimetres, %2: the landmark that lies there (&quot;Pit, central&quot;)</extracomment>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>A place snaps to a landmark, with Shift it does not; L takes it to the nearest.</source>
        <translation>Ein Ort rastet an einer Landmarke ein, mit der Umschalttaste nicht; L setzt ihn an die nächste.</translation>
    </message>
    <message>
        <source>Place of all shapes</source>
        <translation>Lage aller Formen</translation>
    </message>
    <message>
        <source>Rounding of the edges</source>
        <translation>Rundung der Kanten</translation>
    </message>
    <message>
        <source>Rounding %1</source>
        <translation>Rundung %1</translation>
    </message>
    <message>
        <source>Grown by</source>
        <translation>Vergrößert um</translation>
    </message>
    <message>
        <source>Grown by %1</source>
        <translation>Vergrößert um %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TemplateDialog</name>
    <message>
        <source>New exercise from a template</source>
        <translation>Neue Übung aus einer Vorlage</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Make the exercise</source>
        <translation>Übung anlegen</translation>
    </message>
    <message>
        <source>These values make an exercise on tooth %1.</source>
        <translation>Diese Werte ergeben eine Übung an Zahn %1.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Source: free choice</source>
        <translation>Quelle: freie Wahl</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Source: general knowledge, not verified [M]</source>
        <translation>Quelle: allgemeines Wissen, nicht geprüft [M]</translation>
    </message>
    <message>
        <source>Source: %1; the figure is not verified [M]</source>
        <translation>Quelle: %1; die Zahl ist nicht geprüft [M]</translation>
    </message>
    <message>
        <source>Default: yes</source>
        <translation>Voreinstellung: ja</translation>
    </message>
    <message>
        <source>Default: no</source>
        <translation>Voreinstellung: nein</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1, Voreinstellung %2</translation>
    </message>
    <message>
        <source>%1: a number is needed here, %2.</source>
        <translation>%1: Hier wird eine Zahl gebraucht, %2.</translation>
    </message>
    <message>
        <source>%1: “%2” is no number. Possible: %3.</source>
        <translation>%1: „%2“ ist keine Zahl. Möglich: %3.</translation>
    </message>
    <message>
        <source>%1: %2 is outside %3.</source>
        <translation>%1: %2 liegt außerhalb von %3.</translation>
    </message>
    <message>
        <source>%1 has to lie within %2.</source>
        <translation>%1 muss innerhalb von %2 liegen.</translation>
    </message>
    <message>
        <source>Tooth %1 is no premolar or molar.</source>
        <translation>Zahn %1 ist kein Prämolar oder Molar.</translation>
    </message>
    <message>
        <source>With these values nothing is left of the fissures that the preparation follows. A narrower marginal ridge leaves more.</source>
        <translation>Mit diesen Werten bleibt nichts von den Fissuren, denen die Präparation folgt. Eine schmalere Randleiste lässt mehr davon.</translation>
    </message>
    <message>
        <source>With these values nothing is left of the preparation.</source>
        <translation>Mit diesen Werten bleibt nichts von der Präparation.</translation>
    </message>
    <message>
        <source>These values together make no exercise. Values nearer to their defaults do.</source>
        <translation>Diese Werte zusammen ergeben keine Übung. Näher an den Voreinstellungen gelingt es.</translation>
    </message>
    <message>
        <source>The template cannot be used: it is broken at %1.</source>
        <translation>Die Vorlage ist nicht verwendbar: Sie ist fehlerhaft bei %1.</translation>
    </message>
    <message>
        <source>the authors’ notes, section %1</source>
        <translation>Aufzeichnungen der Autoren, Abschnitt %1</translation>
    </message>
</context>
<context>
    <name>cusp::ui::Text</name>
    <message>
        <source>Distance from the target, root mean square</source>
        <translation>Abstand vom Ziel, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Distance from the target, of 95 % of it</source>
        <translation>Abstand vom Ziel, auf 95 % seiner Fläche</translation>
    </message>
    <message>
        <source>Distance from the target, greatest</source>
        <translation>Abstand vom Ziel, größter</translation>
    </message>
    <message>
        <source>Gingival floor above the cemento-enamel junction</source>
        <translation>Gingivaler Boden über der Schmelz-Zement-Grenze</translation>
    </message>
    <message>
        <source>Box height, pulpal to gingival floor</source>
        <translation>Kastenhöhe, pulpaler bis gingivaler Boden</translation>
    </message>
    <message>
        <source>Axial wall in dentine, least</source>
        <translation>Axiale Wand im Dentin, geringste Tiefe</translation>
    </message>
    <message>
        <source>Axial wall in dentine, mean</source>
        <translation>Axiale Wand im Dentin, mittlere Tiefe</translation>
    </message>
    <message>
        <source>Axial wall in dentine, greatest</source>
        <translation>Axiale Wand im Dentin, größte Tiefe</translation>
    </message>
    <message>
        <source>Cavosurface angle, mean</source>
        <translation>Präparationsrandwinkel, Mittel</translation>
    </message>
    <message>
        <source>Clearance, buccal, gingival third</source>
        <translation>Abstand zum Nachbarn, bukkal, gingivales Drittel</translation>
    </message>
    <message>
        <source>Clearance, buccal, middle third</source>
        <translation>Abstand zum Nachbarn, bukkal, mittleres Drittel</translation>
    </message>
    <message>
        <source>Clearance, buccal, occlusal third</source>
        <translation>Abstand zum Nachbarn, bukkal, okklusales Drittel</translation>
    </message>
    <message>
        <source>Clearance, lingual, gingival third</source>
        <translation>Abstand zum Nachbarn, lingual, gingivales Drittel</translation>
    </message>
    <message>
        <source>Clearance, lingual, middle third</source>
        <translation>Abstand zum Nachbarn, lingual, mittleres Drittel</translation>
    </message>
    <message>
        <source>Clearance, lingual, occlusal third</source>
        <translation>Abstand zum Nachbarn, lingual, okklusales Drittel</translation>
    </message>
    <message>
        <source>Clearance, gingival</source>
        <translation>Abstand zum Nachbarn, gingival</translation>
    </message>
    <message>
        <source>Gingival floor, mesiodistal depth</source>
        <translation>Gingivaler Boden, mesiodistale Tiefe</translation>
    </message>
    <message>
        <source>Caries left at the periphery</source>
        <translation>Karies an der Peripherie belassen</translation>
    </message>
    <message>
        <source>Soft caries left over the pulp</source>
        <translation>Weiche Karies über der Pulpa belassen</translation>
    </message>
    <message>
        <source>Firm caries left over the pulp</source>
        <translation>Feste Karies über der Pulpa belassen</translation>
    </message>
    <message>
        <source>Carious enamel left</source>
        <translation>Kariöser Schmelz belassen</translation>
    </message>
    <message>
        <source>Sound tissue lost</source>
        <translation>Gesundes Gewebe verloren</translation>
    </message>
    <message>
        <source>pulpal floor</source>
        <translation>pulpaler Boden</translation>
    </message>
    <message>
        <source>mesial wall</source>
        <translation>mesiale Wand</translation>
    </message>
    <message>
        <source>distal wall</source>
        <translation>distale Wand</translation>
    </message>
    <message>
        <source>buccal wall</source>
        <translation>bukkale Wand</translation>
    </message>
    <message>
        <source>lingual wall</source>
        <translation>linguale Wand</translation>
    </message>
    <message>
        <source>gingival floor</source>
        <translation>gingivaler Boden</translation>
    </message>
    <message>
        <source>axial wall</source>
        <translation>axiale Wand</translation>
    </message>
    <message>
        <source>other walls</source>
        <translation>übrige Wände</translation>
    </message>
    <message>
        <source>Over-cut within tolerance, %1</source>
        <translation>Überpräpariert innerhalb der Toleranz, %1</translation>
    </message>
    <message>
        <source>Over-cut, %1</source>
        <translation>Überpräpariert, %1</translation>
    </message>
    <message>
        <source>Target within %1 µm of the cut</source>
        <translation>Ziel höchstens %1 µm vom Schnitt entfernt</translation>
    </message>
    <message>
        <source>Look at the section and even out where the cut leaves the target.</source>
        <translation>Den Schnitt ansehen und ausgleichen, wo die Präparation vom Ziel abweicht.</translation>
    </message>
    <message>
        <source>Hold the bur at right angles to the tooth’s surface along the margin.</source>
        <translation>Den Bohrer am Rand im rechten Winkel zur Zahnoberfläche halten.</translation>
    </message>
    <message>
        <source>End the box short of the neighbour: the contact stays closed.</source>
        <translation>Den Kasten vor dem Nachbarn enden lassen: Der Kontakt bleibt geschlossen.</translation>
    </message>
    <message>
        <source>Open the box until nothing touches the neighbour.</source>
        <translation>Den Kasten öffnen, bis nichts mehr den Nachbarn berührt.</translation>
    </message>
    <message>
        <source>Keep the box narrow: the margin lies far from the neighbour.</source>
        <translation>Den Kasten schmal halten: Der Rand liegt weit vom Nachbarn entfernt.</translation>
    </message>
    <message>
        <source>Carry the axial wall into dentine, along the outer contour.</source>
        <translation>Die axiale Wand ins Dentin führen, der Außenkontur entlang.</translation>
    </message>
    <message>
        <source>Stop the axial wall just inside the dentine.</source>
        <translation>Die axiale Wand knapp im Dentin enden lassen.</translation>
    </message>
    <message>
        <source>Compare the box with the bur’s length and width before you deepen it.</source>
        <translation>Den Kasten mit Länge und Breite des Bohrers vergleichen, bevor er tiefer wird.</translation>
    </message>
    <message>
        <source>Clear the caries along the dentino-enamel junction until it is hard.</source>
        <translation>Die Karies an der Schmelz-Dentin-Grenze entfernen, bis es dort hart ist.</translation>
    </message>
    <message>
        <source>Remove what is still carious there.</source>
        <translation>Entfernen, was dort noch kariös ist.</translation>
    </message>
    <message>
        <source>Keep to the lesion and its access.</source>
        <translation>Bei der Läsion und ihrem Zugang bleiben.</translation>
    </message>
    <message>
        <source>The record is not there.</source>
        <translation>Diesen Eintrag gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 was not found. Nothing was changed.</source>
        <translation>%1 wurde nicht gefunden. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The database’s folder is not there.</source>
        <translation>Den Ordner der Datenbank gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no folder %1. Make it, or choose another place with --db.</source>
        <translation>Es gibt keinen Ordner %1. Legen Sie ihn an, oder wählen Sie mit --db einen anderen Ort.</translation>
    </message>
    <message>
        <source>The database cannot be made there.</source>
        <translation>Die Datenbank lässt sich dort nicht anlegen.</translation>
    </message>
    <message>
        <source>No file can be made at %1. Choose another place with --db.</source>
        <translation>Unter %1 lässt sich keine Datei anlegen. Wählen Sie mit --db einen anderen Ort.</translation>
    </message>
    <message>
        <source>This file holds no records yet.</source>
        <translation>Diese Datei enthält noch keine Aufzeichnungen.</translation>
    </message>
    <message>
        <source>%1 is empty: Cusp ended before it wrote to it, or it is another file. It was left as it is.</source>
        <translation>%1 ist leer: Cusp endete, bevor es etwas schrieb, oder es ist eine andere Datei. Sie blieb, wie sie ist.</translation>
    </message>
    <message>
        <source>This file is not a Cusp database.</source>
        <translation>Diese Datei ist keine Cusp-Datenbank.</translation>
    </message>
    <message>
        <source>%1 was left as it is. Choose another file with --db.</source>
        <translation>%1 blieb, wie sie ist. Wählen Sie mit --db eine andere Datei.</translation>
    </message>
    <message>
        <source>This database was written by a newer version of Cusp.</source>
        <translation>Diese Datenbank stammt von einer neueren Cusp-Version.</translation>
    </message>
    <message>
        <source>%1 was left as it is. Install the newer version to open it.</source>
        <translation>%1 blieb, wie sie ist. Zum Öffnen die neuere Version installieren.</translation>
    </message>
    <message>
        <source>The database lies on a network drive.</source>
        <translation>Die Datenbank liegt auf einem Netzlaufwerk.</translation>
    </message>
    <message>
        <source>%1 would not be safe there. Move it to this computer’s own disk.</source>
        <translation>%1 wäre dort nicht sicher. Verschieben Sie sie auf den Datenträger dieses Rechners.</translation>
    </message>
    <message>
        <source>The database cannot be written.</source>
        <translation>In die Datenbank kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>%1 or its folder is read-only. Nothing was changed.</source>
        <translation>%1 oder ihr Ordner ist schreibgeschützt. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The disk is full.</source>
        <translation>Der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>Nothing of the last step was written to %1; all before it is kept. Free some space and try again.</source>
        <translation>Vom letzten Schritt wurde nichts in %1 geschrieben; alles davor ist aufbewahrt. Schaffen Sie Platz und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Nothing of the last step was written to %1; all before it is kept.</source>
        <translation>Vom letzten Schritt wurde nichts in %1 geschrieben; alles davor ist aufbewahrt.</translation>
    </message>
    <message>
        <source>Another program holds the database.</source>
        <translation>Ein anderes Programm hält die Datenbank.</translation>
    </message>
    <message>
        <source>The database is damaged.</source>
        <translation>Die Datenbank ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 cannot be read whole. Nothing was changed; restore it from a backup.</source>
        <translation>%1 kann nicht ganz gelesen werden. Nichts wurde geändert; stellen Sie sie aus einer Sicherung wieder her.</translation>
    </message>
    <message>
        <source>Number and password do not match.</source>
        <translation>Nummer und Passwort passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Check both and try again.</source>
        <translation>Prüfen Sie beides und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Too many wrong tries.</source>
        <translation>Zu viele falsche Versuche.</translation>
    </message>
    <message>
        <source>Wait a little and try again.</source>
        <translation>Warten Sie etwas und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Signing in is open again at %1.</source>
        <translation>Die Anmeldung ist um %1 wieder offen.</translation>
    </message>
    <message>
        <source>This account is switched off.</source>
        <translation>Dieses Konto ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Ask an administrator to switch it on again.</source>
        <translation>Bitten Sie die Verwaltung, es wieder einzuschalten.</translation>
    </message>
    <message>
        <source>Your role may not do this.</source>
        <translation>Ihre Rolle darf das nicht.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This password is too short.</source>
        <translation>Dieses Passwort ist zu kurz.</translation>
    </message>
    <message>
        <source>This is the last administrator.</source>
        <translation>Das ist die letzte Person mit Verwaltungsrechten.</translation>
    </message>
    <message>
        <source>Somebody has to manage people. Make another administrator first.</source>
        <translation>Jemand muss die Personen verwalten. Geben Sie zuerst einem anderen Konto die Rolle Verwaltung.</translation>
    </message>
    <message>
        <source>This is there already.</source>
        <translation>Das gibt es schon.</translation>
    </message>
    <message>
        <source>%1 is taken. Nothing was changed.</source>
        <translation>%1 ist vergeben. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>A value is missing or outside its range.</source>
        <translation>Ein Wert fehlt oder liegt außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>Look at %1. Nothing was changed.</source>
        <translation>Sehen Sie bei %1 nach. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The recording cannot be read.</source>
        <translation>Die Aufzeichnung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The database failed.</source>
        <translation>Die Datenbank hat versagt.</translation>
    </message>
    <message>
        <source>This exercise cannot be read.</source>
        <translation>Diese Übung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file %1 cannot be opened.</source>
        <translation>Die Datei %1 lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>%1 is larger than any exercise.</source>
        <translation>%1 ist größer als jede Übung.</translation>
    </message>
    <message>
        <source>The text breaks off or is malformed at %1.</source>
        <translation>Der Text bricht bei %1 ab oder ist dort fehlerhaft.</translation>
    </message>
    <message>
        <source>%1 stands there twice.</source>
        <translation>%1 steht zweimal da.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of Cusp (format %2).</source>
        <translation>%1 stammt von einer neueren Cusp-Version (Format %2).</translation>
    </message>
    <message>
        <source>%1 is not known.</source>
        <translation>%1 ist nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 fehlt.</translation>
    </message>
    <message>
        <source>%1 has to be: %2.</source>
        <translation>%1 muss sein: %2.</translation>
    </message>
    <message>
        <source>%1 has to lie in %2.</source>
        <translation>%1 muss in %2 liegen.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is not an identity.</source>
        <translation>%1 ist keine Kennung.</translation>
    </message>
    <message>
        <source>%1 names no language, or English is missing.</source>
        <translation>%1 nennt keine Sprache, oder Englisch fehlt.</translation>
    </message>
    <message>
        <source>%1 leads out of the exercise’s folder.</source>
        <translation>%1 führt aus dem Ordner der Übung hinaus.</translation>
    </message>
    <message>
        <source>%1 is named twice.</source>
        <translation>%1 ist zweimal angegeben.</translation>
    </message>
    <message>
        <source>%1 names something that is not known.</source>
        <translation>%1 nennt etwas, das nicht bekannt ist.</translation>
    </message>
    <message>
        <source>%1 names something that is not known: %2.</source>
        <translation>%1 nennt etwas, das nicht bekannt ist: %2.</translation>
    </message>
    <message>
        <source>No exercise called %1 comes with the program.</source>
        <translation>Eine Übung namens %1 liegt dem Programm nicht bei.</translation>
    </message>
    <message>
        <source>This file cannot be read.</source>
        <translation>Diese Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>This file cannot be read or written.</source>
        <translation>Diese Datei kann nicht gelesen oder geschrieben werden.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1 is of a kind that is not read here.</source>
        <translation>%1 ist von einer Art, die hier nicht gelesen wird.</translation>
    </message>
    <message>
        <source>Its head is wrong at %1.</source>
        <translation>Ihre Kopfdaten sind bei %1 fehlerhaft.</translation>
    </message>
    <message>
        <source>It uses %1, which is not read here.</source>
        <translation>Sie verwendet %1, das hier nicht gelesen wird.</translation>
    </message>
    <message>
        <source>The sizes at %1 make no volume.</source>
        <translation>Die Größen bei %1 ergeben kein Volumen.</translation>
    </message>
    <message>
        <source>The axes at %1 are oblique or not known.</source>
        <translation>Die Achsen bei %1 sind schief oder nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 names no tissue.</source>
        <translation>%1 nennt kein Gewebe.</translation>
    </message>
    <message>
        <source>%1 ends too early. Copy it again.</source>
        <translation>%1 endet zu früh. Kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is damaged. Copy it again.</source>
        <translation>%1 ist beschädigt. Kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is larger than the limits allow.</source>
        <translation>%1 ist größer, als die Grenzen erlauben.</translation>
    </message>
    <message>
        <source>%1 holds no surface.</source>
        <translation>%1 enthält keine Oberfläche.</translation>
    </message>
    <message>
        <source>There is no part called %1.</source>
        <translation>Es gibt keinen Teil namens %1.</translation>
    </message>
    <message>
        <source>The part %1 encloses nothing.</source>
        <translation>Der Teil %1 umschließt nichts.</translation>
    </message>
    <message>
        <source>The part %1 cuts itself.</source>
        <translation>Der Teil %1 schneidet sich selbst.</translation>
    </message>
    <message>
        <source>An option does not fit.</source>
        <translation>Eine Angabe passt nicht.</translation>
    </message>
    <message>
        <source>Reading %1 broke off.</source>
        <translation>Das Lesen von %1 brach ab.</translation>
    </message>
    <message>
        <source>Reading %1 took longer than allowed.</source>
        <translation>Das Lesen von %1 dauerte länger als erlaubt.</translation>
    </message>
    <message>
        <source>Reading %1 wanted more memory than allowed.</source>
        <translation>Das Lesen von %1 brauchte mehr Speicher als erlaubt.</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reading could not be started.</source>
        <translation>Das Lesen konnte nicht begonnen werden.</translation>
    </message>
    <message>
        <source>Specimens of the kind %1 are not known.</source>
        <translation>Präparate der Art %1 sind nicht bekannt.</translation>
    </message>
    <message>
        <source>The device was not found.</source>
        <translation>Das Gerät wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>%1 is not connected. Check cable and power.</source>
        <translation>%1 ist nicht verbunden. Prüfen Sie Kabel und Strom.</translation>
    </message>
    <message>
        <source>This user may not open the device.</source>
        <translation>Dieses Benutzerkonto darf das Gerät nicht öffnen.</translation>
    </message>
    <message>
        <source>Another program holds the device.</source>
        <translation>Ein anderes Programm hält das Gerät.</translation>
    </message>
    <message>
        <source>Close it and try %1 again.</source>
        <translation>Schließen Sie es und versuchen Sie %1 noch einmal.</translation>
    </message>
    <message>
        <source>The script cannot be read.</source>
        <translation>Das Skript kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Look at %1.</source>
        <translation>Sehen Sie bei %1 nach.</translation>
    </message>
    <message>
        <source>The device does not answer.</source>
        <translation>Das Gerät antwortet nicht.</translation>
    </message>
    <message>
        <source>%1: check cable and power.</source>
        <translation>%1: Kabel und Strom prüfen.</translation>
    </message>
    <message>
        <source>The device failed.</source>
        <translation>Das Gerät hat versagt.</translation>
    </message>
    <message>
        <source>The tooth of this exercise cannot be made.</source>
        <translation>Der Zahn dieser Übung kann nicht erzeugt werden.</translation>
    </message>
    <message>
        <source>This exercise cannot be played.</source>
        <translation>Diese Übung kann nicht ausgeführt werden.</translation>
    </message>
    <message>
        <source>This exercise does not admit this device.</source>
        <translation>Diese Übung lässt dieses Gerät nicht zu.</translation>
    </message>
    <message>
        <source>It is kept up to the last second before %1 failed.</source>
        <translation>Er ist aufbewahrt bis zur letzten Sekunde, bevor %1 versagte.</translation>
    </message>
    <message>
        <source>The device jumped.</source>
        <translation>Das Gerät ist gesprungen.</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Your work is kept.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Ihre Arbeit ist aufbewahrt.</translation>
    </message>
    <message>
        <source>The device answered too late.</source>
        <translation>Das Gerät antwortete zu spät.</translation>
    </message>
    <message>
        <source>The device went quiet.</source>
        <translation>Das Gerät ist verstummt.</translation>
    </message>
    <message>
        <source>The force is off and the clock stands still. Check the cable; your work is kept.</source>
        <translation>Die Kraft ist aus und die Uhr steht. Prüfen Sie das Kabel; Ihre Arbeit ist aufbewahrt.</translation>
    </message>
    <message>
        <source>The device sent a position that is none.</source>
        <translation>Das Gerät sandte eine Position, die keine ist.</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Student/in</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Verwaltung</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Not graded</source>
        <translation>Nicht bewertet</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>Bewertet</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Try-out</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation>Schmelz</translation>
    </message>
    <message>
        <source>Dentine</source>
        <translation>Dentin</translation>
    </message>
    <message>
        <source>Cementum</source>
        <translation>Wurzelzement</translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation>Pulpa</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Gingiva</source>
        <translation>Gingiva</translation>
    </message>
    <message>
        <source>Ligament</source>
        <translation>Desmodont</translation>
    </message>
    <message>
        <source>Amalgam</source>
        <translation>Amalgam</translation>
    </message>
    <message>
        <source>Composite</source>
        <translation>Komposit</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Kunststoff</translation>
    </message>
    <message>
        <source>Material %1</source>
        <translation>Material %1</translation>
    </message>
    <message>
        <source>Neighbour enamel</source>
        <translation>Nachbarschmelz</translation>
    </message>
    <message>
        <source>Neighbour dentine</source>
        <translation>Nachbardentin</translation>
    </message>
    <message>
        <source>Target removed</source>
        <translation>Ziel abgetragen</translation>
    </message>
    <message>
        <source>Floor depth, shallowest</source>
        <translation>Bodentiefe, geringste</translation>
    </message>
    <message>
        <source>Floor depth, mean</source>
        <translation>Bodentiefe, mittlere</translation>
    </message>
    <message>
        <source>Floor depth, deepest</source>
        <translation>Bodentiefe, größte</translation>
    </message>
    <message>
        <source>Dentine over pulp</source>
        <translation>Dentin über Pulpa</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Pulp opened</source>
        <translation>Pulpa eröffnet</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1 abgetragen</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Full points</source>
        <translation>Volle Punktzahl</translation>
    </message>
    <message>
        <source>Could not be measured</source>
        <translation>Nicht messbar</translation>
    </message>
    <message>
        <source>%1, %2 deeper than %3</source>
        <translation>%1, %2 tiefer als %3</translation>
    </message>
    <message>
        <source>%1, %2 short of %3</source>
        <translation>%1, %2 flacher als %3</translation>
    </message>
    <message>
        <source>%1; full points up to %2</source>
        <translation>%1; volle Punktzahl bis %2</translation>
    </message>
    <message>
        <source>%1 removed; full points from %2</source>
        <translation>%1 abgetragen; volle Punktzahl ab %2</translation>
    </message>
    <message>
        <source>%1; full points from %2</source>
        <translation>%1; volle Punktzahl ab %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 point(s) lost</source>
        <translation>
            <numerusform>%1: %2 Punkt verloren</numerusform>
            <numerusform>%1: %2 Punkte verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn the view and look for what remains inside the target line.</source>
        <translation>Drehen Sie die Ansicht und suchen Sie, was innerhalb der Ziellinie übrig ist.</translation>
    </message>
    <message>
        <source>Lift off and read the depth before you go deeper.</source>
        <translation>Heben Sie ab und lesen Sie die Tiefe, bevor Sie tiefer gehen.</translation>
    </message>
    <message>
        <source>Keep the bur’s edge inside the target line; push less near the walls.</source>
        <translation>Halten Sie den Rand des Bohrers innerhalb der Ziellinie; drücken Sie nahe den Wänden weniger.</translation>
    </message>
    <message>
        <source>Turn the view and clear the corners along the walls.</source>
        <translation>Drehen Sie die Ansicht und räumen Sie die Ecken entlang der Wände aus.</translation>
    </message>
    <message>
        <source>Stop pushing at the required depth and move sideways.</source>
        <translation>Drücken Sie bei der Solltiefe nicht weiter und führen Sie den Bohrer seitwärts.</translation>
    </message>
    <message>
        <source>Cut to the required depth over the whole floor.</source>
        <translation>Arbeiten Sie am ganzen Boden bis zur Solltiefe.</translation>
    </message>
    <message>
        <source>Keep away from the pulp: stop at the required depth.</source>
        <translation>Bleiben Sie von der Pulpa weg: Enden Sie bei der Solltiefe.</translation>
    </message>
    <message>
        <source>Push less; let the bur do the work.</source>
        <translation>Drücken Sie weniger; lassen Sie den Bohrer arbeiten.</translation>
    </message>
    <message>
        <source>Plan the way of the bur before the first cut.</source>
        <translation>Planen Sie den Weg des Bohrers vor dem ersten Abtrag.</translation>
    </message>
    <message>
        <source>Take away less of it.</source>
        <translation>Tragen Sie weniger davon ab.</translation>
    </message>
    <message>
        <source>Take away more of it.</source>
        <translation>Tragen Sie mehr davon ab.</translation>
    </message>
    <message>
        <source>The device did not open.</source>
        <translation>Das Gerät ließ sich nicht öffnen.</translation>
    </message>
    <message>
        <source>The stored exercise cannot be read.</source>
        <translation>Die gespeicherte Übung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The database refused.</source>
        <translation>Die Datenbank lehnte ab.</translation>
    </message>
    <message>
        <source>It was stopped at tick %1 and is not graded; the recording is kept.</source>
        <translation>Er wurde bei Takt %1 angehalten und ist nicht bewertet; die Aufzeichnung ist aufbewahrt.</translation>
    </message>
    <message>
        <source>This computer is too slow for this exercise.</source>
        <translation>Dieser Rechner ist zu langsam für diese Übung.</translation>
    </message>
    <message>
        <source>It opens with its stored tooth and grade, but is not computed again (engine %1).</source>
        <translation>Er öffnet sich mit gespeichertem Zahn und gespeicherter Bewertung, wird aber nicht neu berechnet (Rechenkern %1).</translation>
    </message>
    <message>
        <source>The stored grade is kept; the tooth of %1 cannot be shown.</source>
        <translation>Die gespeicherte Bewertung ist aufbewahrt; der Zahn von %1 kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>The surface is open at %1 mm. Let it be mended, or close it there.</source>
        <translation>Die Oberfläche ist bei %1 mm offen. Lassen Sie sie ausbessern oder schließen Sie sie dort.</translation>
    </message>
    <message>
        <source>The surface is turned inside out at %1 mm. Let it be mended.</source>
        <translation>Die Oberfläche ist bei %1 mm nach innen gewendet. Lassen Sie sie ausbessern.</translation>
    </message>
    <message>
        <source>Cut without coolant</source>
        <translation>Ohne Kühlung gebohrt</translation>
    </message>
    <message>
        <source>Tooth overheated</source>
        <translation>Zahn überhitzt</translation>
    </message>
    <message>
        <source>%1 without coolant; full points up to %2</source>
        <translation>%1 ohne Kühlung; volle Punkte bis %2</translation>
    </message>
    <message>
        <source>%1 warmer; full points up to %2</source>
        <translation>%1 wärmer; volle Punkte bis %2</translation>
    </message>
    <message>
        <source>Run the coolant before the bur touches the tooth.</source>
        <translation>Kühlung einschalten, bevor der Bohrer den Zahn berührt.</translation>
    </message>
    <message>
        <source>Run the coolant, push less, and lift off now and then.</source>
        <translation>Kühlen, weniger drücken und zwischendurch absetzen.</translation>
    </message>
    <message>
        <source>Emulated Falcon</source>
        <translation>Nachgebildeter Falcon</translation>
    </message>
    <message>
        <source>The device goes before other programs.</source>
        <translation>Das Gerät hat Vorrang vor anderen Programmen.</translation>
    </message>
    <message>
        <source>Other programs may delay the device.</source>
        <translation>Andere Programme können das Gerät aufhalten.</translation>
    </message>
    <message>
        <source>This user has no right to real-time priority. An administrator can give it (rtprio).</source>
        <translation>Dieses Benutzerkonto hat kein Recht auf Echtzeit-Vorrang. Die Verwaltung kann es geben (rtprio).</translation>
    </message>
    <message>
        <source>Install rtkit, or give this user the right to real-time priority (rtprio).</source>
        <translation>Installieren Sie rtkit oder geben Sie diesem Benutzerkonto das Recht auf Echtzeit-Vorrang (rtprio).</translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation>mesiobukkal</translation>
    </message>
    <message>
        <source>mesiopalatal</source>
        <translation>mesiopalatinal</translation>
    </message>
    <message>
        <source>mesiolingual</source>
        <translation>mesiolingual</translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation>distobukkal</translation>
    </message>
    <message>
        <source>distopalatal</source>
        <translation>distopalatinal</translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation>distolingual</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Read the depth before each stroke, and stop at the required depth.</source>
        <translation>Lesen Sie vor jedem Zug die Tiefe ab und enden Sie bei der Solltiefe.</translation>
    </message>
    <message>
        <source>mesial</source>
        <translation>mesial</translation>
    </message>
    <message>
        <source>distal</source>
        <translation>distal</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>bukkal</translation>
    </message>
    <message>
        <source>palatal</source>
        <translation>palatinal</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>lingual</translation>
    </message>
    <message>
        <source>Stored with marking %1: the same points.</source>
        <translation>Gespeichert mit Bewertung %1: dieselben Punkte.</translation>
    </message>
    <message>
        <source>Stored with marking %1: %2 points. What differs: %3.</source>
        <translation>Gespeichert mit Bewertung %1: %2 Punkte. Unterschiede: %3.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>This computer has too little free memory to check a password.</source>
        <translation>Dieser Rechner hat zu wenig freien Speicher, um ein Passwort zu prüfen.</translation>
    </message>
    <message>
        <source>Nothing was changed. Close other programs and try again.</source>
        <translation>Nichts wurde geändert. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>A file could not be read or written.</source>
        <translation>Eine Datei konnte nicht gelesen oder geschrieben werden.</translation>
    </message>
    <message>
        <source>A PIN has exactly six digits.</source>
        <translation>Eine PIN hat genau sechs Ziffern.</translation>
    </message>
    <message>
        <source>A password has at least 8 characters. Nothing was changed.</source>
        <translation>Ein Passwort hat mindestens 8 Zeichen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This account is not there.</source>
        <translation>Dieses Konto gibt es nicht.</translation>
    </message>
    <message>
        <source>This attempt is not there.</source>
        <translation>Diesen Versuch gibt es nicht.</translation>
    </message>
    <message>
        <source>This exercise is not there.</source>
        <translation>Diese Übung gibt es nicht.</translation>
    </message>
    <message>
        <source>A part of the records is not there.</source>
        <translation>Ein Teil der Aufzeichnungen fehlt.</translation>
    </message>
    <message>
        <source>A number has 1 to 64 characters.</source>
        <translation>Eine Nummer hat 1 bis 64 Zeichen.</translation>
    </message>
    <message>
        <source>A name has 1 to 200 characters.</source>
        <translation>Ein Name hat 1 bis 200 Zeichen.</translation>
    </message>
    <message>
        <source>Only students have a PIN.</source>
        <translation>Nur Studierende haben eine PIN.</translation>
    </message>
    <message>
        <source>The due date lies before the first day.</source>
        <translation>Der Abgabetermin liegt vor dem ersten Tag.</translation>
    </message>
    <message>
        <source>%1 signs in with a PIN of six digits.</source>
        <translation>%1 meldet sich mit einer PIN aus sechs Ziffern an.</translation>
    </message>
    <message>
        <source>%1 signs in with a password.</source>
        <translation>%1 meldet sich mit einem Passwort an.</translation>
    </message>
    <message>
        <source>This number or name is taken.</source>
        <translation>Diese Nummer oder dieser Name ist vergeben.</translation>
    </message>
    <message>
        <source>This attempt is not in a state that allows it.</source>
        <translation>Dieser Versuch ist nicht in einem Zustand, der das zulässt.</translation>
    </message>
    <message>
        <source>%1 is damaged; the grade and all other attempts are kept.</source>
        <translation>%1 ist beschädigt; die Bewertung und alle anderen Versuche sind aufbewahrt.</translation>
    </message>
    <message>
        <source>Number and PIN do not match.</source>
        <translation>Nummer und PIN passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Too many wrong tries for %1.</source>
        <translation>Zu viele falsche Eingaben für %1.</translation>
    </message>
    <message>
        <source>The account %1 is switched off.</source>
        <translation>Das Konto %1 ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>There is no account %1.</source>
        <translation>Es gibt kein Konto %1.</translation>
    </message>
    <message>
        <source>The number %1 is taken.</source>
        <translation>Die Nummer %1 ist vergeben.</translation>
    </message>
    <message>
        <source>Nothing was changed. Choose another number.</source>
        <translation>Nichts wurde geändert. Wählen Sie eine andere Nummer.</translation>
    </message>
    <message>
        <source>The records are older than they were.</source>
        <translation>Die Aufzeichnungen sind älter, als sie waren.</translation>
    </message>
    <message>
        <source>An earlier copy was put in their place, or entries were taken out: results may be missing.</source>
        <translation>Eine frühere Kopie steht an ihrer Stelle, oder Einträge wurden entfernt: Ergebnisse können fehlen.</translation>
    </message>
    <message>
        <source>The counter beside the records’ key is missing.</source>
        <translation>Der Zähler neben dem Schlüssel der Aufzeichnungen fehlt.</translation>
    </message>
    <message>
        <source>An earlier copy of the records put in their place would not have been noticed.</source>
        <translation>Eine frühere Kopie an ihrer Stelle wäre nicht aufgefallen.</translation>
    </message>
    <message>
        <source>The counter beside the records’ key is not theirs.</source>
        <translation>Der Zähler neben dem Schlüssel gehört nicht zu diesen Aufzeichnungen.</translation>
    </message>
    <message>
        <source>It was changed or comes from other records: an earlier copy would not have been noticed.</source>
        <translation>Er wurde geändert oder stammt von anderen Aufzeichnungen: Eine frühere Kopie wäre nicht aufgefallen.</translation>
    </message>
    <message>
        <source>The records’ audit log was changed.</source>
        <translation>Das Protokoll der Aufzeichnungen wurde geändert.</translation>
    </message>
    <message>
        <source>Its last entries were changed or taken out: results or accounts may have been too.</source>
        <translation>Seine letzten Einträge wurden geändert oder entfernt; Ergebnisse oder Konten vielleicht auch.</translation>
    </message>
    <message>
        <source>Before you rely on them, look at what this command names: cusp history %1 verify</source>
        <translation>Bevor Sie sich darauf verlassen: ansehen, was dieser Befehl nennt: cusp history %1 verify</translation>
    </message>
    <message>
        <source>Results and reports can be read. Nothing can be drilled or changed until %1 can be written again.</source>
        <translation>Ergebnisse und Berichte können gelesen werden. Gebohrt oder geändert werden kann erst wieder, wenn %1 geschrieben werden kann.</translation>
    </message>
    <message>
        <source>Look at %1. No attempt was started.</source>
        <translation>Sehen Sie bei %1 nach. Kein Versuch wurde begonnen.</translation>
    </message>
    <message>
        <source>%1 refused. No attempt was started.</source>
        <translation>%1 lehnte ab. Kein Versuch wurde begonnen.</translation>
    </message>
    <message>
        <source>%1 was not written. Earlier attempts are kept.</source>
        <translation>%1 wurde nicht geschrieben. Versuche davor sind aufbewahrt.</translation>
    </message>
    <message>
        <source>The attempt could not be recorded any further.</source>
        <translation>Der Versuch konnte nicht weiter aufgezeichnet werden.</translation>
    </message>
    <message>
        <source>Two computations of this attempt differ.</source>
        <translation>Zwei Berechnungen dieses Versuchs weichen voneinander ab.</translation>
    </message>
    <message>
        <source>The attempt ended as interrupted. All of it is kept and can be graded as it stands.</source>
        <translation>Der Versuch endete als unterbrochen. Er ist ganz aufbewahrt und kann bewertet werden, wie er ist.</translation>
    </message>
    <message>
        <source>This attempt was recorded by another version of Cusp.</source>
        <translation>Dieser Versuch wurde von einer anderen Cusp-Version aufgezeichnet.</translation>
    </message>
    <message>
        <source>The tooth is not the one this attempt began with.</source>
        <translation>Der Zahn ist nicht der, mit dem dieser Versuch begann.</translation>
    </message>
    <message>
        <source>The attempt could not be played.</source>
        <translation>Der Versuch konnte nicht ausgeführt werden.</translation>
    </message>
    <message>
        <source>Over-cut within tolerance, floor</source>
        <translation>Überpräpariert in Toleranz, Boden</translation>
    </message>
    <message>
        <source>Over-cut within tolerance, walls</source>
        <translation>Überpräpariert in Toleranz, Wände</translation>
    </message>
    <message>
        <source>Over-cut, floor</source>
        <translation>Überpräpariert, Boden</translation>
    </message>
    <message>
        <source>Over-cut, walls</source>
        <translation>Überpräpariert, Wände</translation>
    </message>
    <message>
        <source>Not removed</source>
        <translation>Nicht entfernt</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Lehrkraft</translation>
    </message>
    <message>
        <source>Scripted operator</source>
        <translation>Automatischer Operateur</translation>
    </message>
    <message>
        <source>Carious dentine</source>
        <translation>Kariöses Dentin</translation>
    </message>
    <message>
        <source>Carious enamel</source>
        <translation>Kariöser Schmelz</translation>
    </message>
    <message>
        <source>Firm carious dentine</source>
        <translation>Festes kariöses Dentin</translation>
    </message>
    <message>
        <source>Mesial wall, divergence</source>
        <translation>Mesiale Wand, Divergenz</translation>
    </message>
    <message>
        <source>Distal wall, divergence</source>
        <translation>Distale Wand, Divergenz</translation>
    </message>
    <message>
        <source>Buccal wall, divergence</source>
        <translation>Bukkale Wand, Divergenz</translation>
    </message>
    <message>
        <source>Lingual wall, divergence</source>
        <translation>Linguale Wand, Divergenz</translation>
    </message>
    <message>
        <source>Convergence, mesial to distal wall</source>
        <translation>Konvergenz von mesialer und distaler Wand</translation>
    </message>
    <message>
        <source>Convergence, buccal to lingual wall</source>
        <translation>Konvergenz von bukkaler und lingualer Wand</translation>
    </message>
    <message>
        <source>Floor, deviation from flat</source>
        <translation>Boden, Abweichung von der Ebene</translation>
    </message>
    <message>
        <source>Floor, tilt</source>
        <translation>Boden, Neigung</translation>
    </message>
    <message>
        <source>Isthmus, least width</source>
        <translation>Isthmus, geringste Breite</translation>
    </message>
    <message>
        <source>Mesial marginal ridge</source>
        <translation>Mesiale Randleiste</translation>
    </message>
    <message>
        <source>Distal marginal ridge</source>
        <translation>Distale Randleiste</translation>
    </message>
    <message>
        <source>Hold the bur along the axis of the preparation and draw it along the wall without leaning.</source>
        <translation>Halten Sie den Bohrer in der Achse der Präparation und führen Sie ihn ohne Neigung an der Wand entlang.</translation>
    </message>
    <message>
        <source>Go over the whole floor once more at one depth.</source>
        <translation>Gehen Sie noch einmal in gleicher Tiefe über den ganzen Boden.</translation>
    </message>
    <message>
        <source>Compare the width with the bur before you widen the outline.</source>
        <translation>Vergleichen Sie die Breite mit dem Bohrer, bevor Sie den Umriss erweitern.</translation>
    </message>
    <message>
        <source>Carry the outline closer to the marginal ridge; read its thickness from above.</source>
        <translation>Führen Sie den Umriss näher an die Randleiste; beurteilen Sie ihre Dicke von oben.</translation>
    </message>
    <message>
        <source>Stop short of the marginal ridge; read its thickness from above.</source>
        <translation>Bleiben Sie vor der Randleiste stehen; beurteilen Sie ihre Dicke von oben.</translation>
    </message>
    <message>
        <source>Look where the protected part lies before you begin, and keep the bur off it.</source>
        <translation>Sehen Sie nach, wo das Geschützte liegt, bevor Sie beginnen, und halten Sie den Bohrer davon fern.</translation>
    </message>
    <message>
        <source>Removed of what is protected</source>
        <translation>Von geschützten Strukturen abgetragen</translation>
    </message>
    <message>
        <source>Protected part damaged</source>
        <translation>Geschützte Struktur verletzt</translation>
    </message>
    <message>
        <source>Something protected was damaged</source>
        <translation>Eine geschützte Struktur wurde verletzt</translation>
    </message>
    <message>
        <source>Brings no points: it takes a device of %1 axes, and this one has %2</source>
        <translation>Ohne Punkte: Dafür braucht es ein Gerät mit %1 Achsen, dieses hat %2</translation>
    </message>
    <message>
        <source>Unsupported enamel</source>
        <translation>Nicht dentingestützter Schmelz</translation>
    </message>
    <message>
        <source>Let every wall end on dentine: take away enamel that has none beneath it.</source>
        <translation>Lassen Sie jede Wand auf Dentin enden: Entfernen Sie Schmelz, unter dem keines liegt.</translation>
    </message>
    <message>
        <source>Beginner</source>
        <comment>level of an exercise</comment>
        <translation>Einstieg</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <comment>level of an exercise</comment>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Advanced</source>
        <comment>level of an exercise</comment>
        <translation>Fortgeschritten</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: level of an exercise, %2: time that it takes.</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 names no kind or state of a landmark: %2.</source>
        <translation>%1 nennt weder Art noch Stand einer Landmarke: %2.</translation>
    </message>
    <message>
        <source>%1 names no level of an exercise: %2.</source>
        <translation>%1 nennt keinen Schwierigkeitsgrad einer Übung: %2.</translation>
    </message>
    <message>
        <source>This remark is withdrawn already.</source>
        <translation>Diese Bemerkung ist schon zurückgenommen.</translation>
    </message>
    <message>
        <source>A comment or reason has 1 to 10,000 characters.</source>
        <translation>Ein Kommentar oder eine Begründung hat 1 bis 10.000 Zeichen.</translation>
    </message>
    <message>
        <source>A start code has 4 to 32 characters.</source>
        <translation>Ein Startcode hat 4 bis 32 Zeichen.</translation>
    </message>
    <message>
        <source>This is not the start code.</source>
        <translation>Das ist nicht der Startcode.</translation>
    </message>
    <message>
        <source>Ask the invigilator and type it again.</source>
        <translation>Fragen Sie die Aufsicht und geben Sie ihn noch einmal ein.</translation>
    </message>
    <message>
        <source>This exercise is not assigned to you.</source>
        <translation>Diese Übung ist Ihnen nicht zugewiesen.</translation>
    </message>
    <message>
        <source>Ask your instructor. Nothing was changed.</source>
        <translation>Fragen Sie Ihre Lehrkraft. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This result is not released yet.</source>
        <translation>Dieses Ergebnis ist noch nicht freigegeben.</translation>
    </message>
    <message>
        <source>It is shown here when your examiner releases it.</source>
        <translation>Es erscheint hier, wenn es freigegeben wird.</translation>
    </message>
    <message>
        <source>This assignment is not open yet.</source>
        <translation>Diese Zuweisung ist noch nicht offen.</translation>
    </message>
    <message>
        <source>The time for this assignment is over.</source>
        <translation>Die Zeit für diese Zuweisung ist um.</translation>
    </message>
    <message>
        <source>Every attempt of this assignment is used.</source>
        <translation>Alle Versuche dieser Zuweisung sind verbraucht.</translation>
    </message>
    <message>
        <source>This attempt has no grade yet.</source>
        <translation>Dieser Versuch hat noch keine Bewertung.</translation>
    </message>
    <message>
        <source>This result is released already.</source>
        <translation>Dieses Ergebnis ist schon freigegeben.</translation>
    </message>
    <message>
        <source>A failed result is released only after an examiner has confirmed it.</source>
        <translation>Ein nicht bestandenes Ergebnis wird erst freigegeben, wenn es jemand bestätigt hat.</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>, second %1 of the session</source>
        <translation>, Sekunde %1 des Versuchs</translation>
    </message>
    <message>
        <source>, in the audit log since %1</source>
        <translation>, im Protokoll seit %1</translation>
    </message>
    <message>
        <source>The record was changed: %1%2.</source>
        <translation>Die Aufzeichnung wurde verändert: %1%2.</translation>
    </message>
    <message>
        <source>A part of the record is missing: %1%2.</source>
        <translation>Ein Teil der Aufzeichnung fehlt: %1%2.</translation>
    </message>
    <message>
        <source>Something was added to the record: %1%2.</source>
        <translation>Der Aufzeichnung wurde etwas hinzugefügt: %1%2.</translation>
    </message>
    <message>
        <source>The record’s chain is broken: %1%2.</source>
        <translation>Die Kette der Aufzeichnung ist unterbrochen: %1%2.</translation>
    </message>
    <message>
        <source>The signature over the record does not hold: %1%2.</source>
        <translation>Die Signatur der Aufzeichnung stimmt nicht: %1%2.</translation>
    </message>
    <message>
        <source>The station’s key is not the one that signed: %1%2.</source>
        <translation>Der Schlüssel der Station ist nicht der, mit dem signiert wurde: %1%2.</translation>
    </message>
    <message>
        <source>The record cannot be read: %1%2.</source>
        <translation>Die Aufzeichnung kann nicht gelesen werden: %1%2.</translation>
    </message>
    <message>
        <source>The record does not add up: %1%2.</source>
        <translation>Die Aufzeichnung geht nicht auf: %1%2.</translation>
    </message>
    <message>
        <source>The record is not the one that was sealed: %1%2.</source>
        <translation>Die Aufzeichnung ist nicht die, die versiegelt wurde: %1%2.</translation>
    </message>
    <message>
        <source>The database is older than the counter beside its key, or its audit log was cut: %1%2.</source>
        <translation>Die Datenbank ist älter als der Zähler neben ihrem Schlüssel, oder ihr Protokoll wurde gekürzt: %1%2.</translation>
    </message>
    <message>
        <source>The counter beside the station’s key is missing: %1%2.</source>
        <translation>Der Zähler neben dem Schlüssel der Station fehlt: %1%2.</translation>
    </message>
    <message>
        <source>The counter beside the station’s key is not the one of this database: %1%2.</source>
        <translation>Der Zähler neben dem Schlüssel der Station gehört nicht zu dieser Datenbank: %1%2.</translation>
    </message>
    <message>
        <source>The audit log’s end was changed or taken out: %1%2.</source>
        <translation>Das Ende des Protokolls wurde geändert oder entfernt: %1%2.</translation>
    </message>
    <message>
        <source>The lists show something else than the record: %1%2.</source>
        <translation>Die Listen zeigen etwas anderes als die Aufzeichnung: %1%2.</translation>
    </message>
    <message>
        <source>This is your own account.</source>
        <translation>Das ist Ihr eigenes Konto.</translation>
    </message>
    <message>
        <source>Another administrator erases it. Nothing was changed.</source>
        <translation>Jemand anders aus der Verwaltung löscht es. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>An attempt of this person still runs.</source>
        <translation>Ein Versuch dieser Person läuft noch.</translation>
    </message>
    <message>
        <source>%1 is not an exercise that Cusp saved as a file.</source>
        <translation>%1 ist keine Übung, die Cusp als Datei gespeichert hat.</translation>
    </message>
    <message>
        <source>%1 is not whole: it breaks off. Copy the file again.</source>
        <translation>%1 ist nicht vollständig: die Datei bricht ab. Kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 was damaged or changed after it was saved. Copy the file again.</source>
        <translation>%1 wurde nach dem Speichern beschädigt oder verändert. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 is missing in the file.</source>
        <translation>%1 fehlt in der Datei.</translation>
    </message>
    <message>
        <source>%1 does not belong in the file of an exercise.</source>
        <translation>%1 gehört nicht in die Datei einer Übung.</translation>
    </message>
    <message>
        <source>The exercise cannot be saved as a file.</source>
        <translation>Die Übung lässt sich nicht als Datei speichern.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>This exercise cannot be used.</source>
        <translation>Diese Übung ist nicht verwendbar.</translation>
    </message>
    <message>
        <source>The checks refuse it at %1. Nothing was changed.</source>
        <translation>Die Kontrollen weisen sie zurück, bei %1. Nichts wurde verändert.</translation>
    </message>
    <message>
        <source>The replay comes to another state at tick %1.</source>
        <translation>Die Wiedergabe kommt bei Takt %1 zu einem anderen Zustand.</translation>
    </message>
    <message>
        <source>The replay comes to another tooth than the one that is stored.</source>
        <translation>Die Wiedergabe kommt zu einem anderen Zahn als dem gespeicherten.</translation>
    </message>
    <message>
        <source>The replay comes to another grade than the one that is stored (%1).</source>
        <translation>Die Wiedergabe kommt zu einer anderen Bewertung als der gespeicherten (%1).</translation>
    </message>
    <message>
        <source>Extra time is 0 to 400 % of the time limit.</source>
        <translation>Die Zeitzugabe beträgt 0 bis 400 % der Zeitgrenze.</translation>
    </message>
    <message>
        <source>Signed in</source>
        <translation>Angemeldet</translation>
    </message>
    <message>
        <source>Sign-in failed: wrong password or PIN</source>
        <translation>Anmeldung gescheitert: falsches Passwort oder falsche PIN</translation>
    </message>
    <message>
        <source>Account created</source>
        <translation>Konto angelegt</translation>
    </message>
    <message>
        <source>Name or number of an account changed</source>
        <translation>Name oder Nummer eines Kontos geändert</translation>
    </message>
    <message>
        <source>Role of an account changed</source>
        <translation>Rolle eines Kontos geändert</translation>
    </message>
    <message>
        <source>Account disabled</source>
        <translation>Konto ausgeschaltet</translation>
    </message>
    <message>
        <source>Account enabled</source>
        <translation>Konto eingeschaltet</translation>
    </message>
    <message>
        <source>Password changed</source>
        <translation>Passwort geändert</translation>
    </message>
    <message>
        <source>PIN changed</source>
        <translation>PIN geändert</translation>
    </message>
    <message>
        <source>Person erased</source>
        <translation>Person gelöscht</translation>
    </message>
    <message>
        <source>Text of a comment erased</source>
        <translation>Text eines Kommentars gelöscht</translation>
    </message>
    <message>
        <source>Text of a statement erased</source>
        <translation>Text einer Erklärung gelöscht</translation>
    </message>
    <message>
        <source>Account sealed as it was found</source>
        <translation>Konto versiegelt, wie es vorgefunden wurde</translation>
    </message>
    <message>
        <source>Cohort created</source>
        <translation>Kohorte angelegt</translation>
    </message>
    <message>
        <source>Student added to a cohort</source>
        <translation>Student/in in eine Kohorte aufgenommen</translation>
    </message>
    <message>
        <source>Student taken out of a cohort</source>
        <translation>Student/in aus einer Kohorte genommen</translation>
    </message>
    <message>
        <source>Cohort sealed as it was found</source>
        <translation>Kohorte versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Exercise assigned</source>
        <translation>Übung zugewiesen</translation>
    </message>
    <message>
        <source>Assessment set</source>
        <translation>Prüfung angesetzt</translation>
    </message>
    <message>
        <source>Assignment sealed as it was found</source>
        <translation>Zuweisung versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Assessment sealed as it was found</source>
        <translation>Prüfung versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Version of an exercise published</source>
        <translation>Version einer Übung veröffentlicht</translation>
    </message>
    <message>
        <source>Version of an exercise kept</source>
        <translation>Version einer Übung aufbewahrt</translation>
    </message>
    <message>
        <source>Version of an exercise withdrawn</source>
        <translation>Version einer Übung zurückgezogen</translation>
    </message>
    <message>
        <source>Version of an exercise sealed as it was found</source>
        <translation>Version einer Übung versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Withdrawal of a version sealed as it was found</source>
        <translation>Rückzug einer Version versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>Attempt sealed as it was found</source>
        <translation>Versuch versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>Statement about an attempt signed</source>
        <translation>Erklärung zu einem Versuch signiert</translation>
    </message>
    <message>
        <source>Statement about an attempt sealed as it was found</source>
        <translation>Erklärung zu einem Versuch versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Comment sealed as it was found</source>
        <translation>Kommentar versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>Records backed up</source>
        <translation>Aufzeichnungen gesichert</translation>
    </message>
    <message>
        <source>Records restored from a backup</source>
        <translation>Aufzeichnungen aus einer Sicherung wiederhergestellt</translation>
    </message>
    <message>
        <source>Attempt saved as an appeal pack</source>
        <translation>Versuch als Einspruchsakte gespeichert</translation>
    </message>
    <message>
        <source>Attempts exported as a list</source>
        <translation>Versuche als Liste exportiert</translation>
    </message>
    <message>
        <source>Audit log exported as a list</source>
        <translation>Protokoll als Liste exportiert</translation>
    </message>
    <message>
        <source>Lists made anew from the records</source>
        <translation>Listen aus den Aufzeichnungen neu erstellt</translation>
    </message>
    <message>
        <source>Key of this station added</source>
        <translation>Schlüssel dieser Station hinzugefügt</translation>
    </message>
    <message>
        <source>Sealing of the records began</source>
        <translation>Versiegelung der Aufzeichnungen begonnen</translation>
    </message>
    <message>
        <source>Audit log found changed at its end</source>
        <translation>Protokoll am Ende verändert vorgefunden</translation>
    </message>
    <message>
        <source>Counter beside the records’ key found missing</source>
        <translation>Zähler beim Schlüssel der Aufzeichnungen fehlte</translation>
    </message>
    <message>
        <source>Counter beside the records’ key found changed</source>
        <translation>Zähler beim Schlüssel der Aufzeichnungen verändert vorgefunden</translation>
    </message>
    <message>
        <source>Records found older than their counter</source>
        <translation>Aufzeichnungen älter als ihr Zähler vorgefunden</translation>
    </message>
    <message>
        <source>Attempt started</source>
        <translation>Versuch begonnen</translation>
    </message>
    <message>
        <source>Attempt interrupted</source>
        <translation>Versuch unterbrochen</translation>
    </message>
    <message>
        <source>Attempt resumed</source>
        <translation>Versuch fortgesetzt</translation>
    </message>
    <message>
        <source>Attempt finished</source>
        <translation>Versuch beendet</translation>
    </message>
    <message>
        <source>Attempt graded</source>
        <translation>Versuch bewertet</translation>
    </message>
    <message>
        <source>Attempt closed</source>
        <translation>Versuch abgeschlossen</translation>
    </message>
    <message>
        <source>Sign-ins</source>
        <translation>Anmeldungen</translation>
    </message>
    <message>
        <source>Accounts</source>
        <translation>Konten</translation>
    </message>
    <message>
        <source>Cohorts and assignments</source>
        <translation>Kohorten und Zuweisungen</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Records and exports</source>
        <translation>Aufzeichnungen und Exporte</translation>
    </message>
    <message numerus="yes">
        <source>Sign-in failed, %n wrong time(s) in a row</source>
        <translation>
            <numerusform>Anmeldung gescheitert, %n-mal falsch</numerusform>
            <numerusform>Anmeldung gescheitert, %n-mal falsch hintereinander</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Records backed up, %n session(s)</source>
        <translation>
            <numerusform>Aufzeichnungen gesichert, %n Versuch</numerusform>
            <numerusform>Aufzeichnungen gesichert, %n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Audit log exported, %n entry(ies)</source>
        <translation>
            <numerusform>Protokoll exportiert, %n Eintrag</numerusform>
            <numerusform>Protokoll exportiert, %n Einträge</numerusform>
        </translation>
    </message>
    <message>
        <source>The operator cannot cut it.</source>
        <translation>Der Operateur kann die Übung nicht präparieren.</translation>
    </message>
    <message>
        <source>No bur of the exercise fits into its target.</source>
        <translation>Kein Bohrer der Übung passt in ihr Ziel.</translation>
    </message>
    <message>
        <source>More is cut than a volume of this exercise can keep.</source>
        <translation>Es ist mehr abgetragen, als ein Volumen dieser Übung fassen kann.</translation>
    </message>
    <message>
        <source>Reference operator</source>
        <translation>Referenzoperateur</translation>
    </message>
    <message>
        <source>Competent operator</source>
        <translation>Geübter Operateur</translation>
    </message>
    <message>
        <source>Novice operator</source>
        <translation>Unerfahrener Operateur</translation>
    </message>
    <message>
        <source>Results exported for a gradebook</source>
        <translation>Ergebnisse für ein Notenbuch exportiert</translation>
    </message>
    <message>
        <source>File for other stations given out</source>
        <translation>Datei für andere Stationen herausgegeben</translation>
    </message>
    <message>
        <source>File of another station read in</source>
        <translation>Datei einer anderen Station eingelesen</translation>
    </message>
    <message>
        <source>File of another station named by its station</source>
        <translation>Datei einer anderen Station von ihrer Station genannt</translation>
    </message>
    <message>
        <source>Key of another station trusted</source>
        <translation>Schlüssel einer anderen Station bekannt gemacht</translation>
    </message>
    <message>
        <source>Trust in another station’s key changed</source>
        <translation>Vertrauen in den Schlüssel einer anderen Station geändert</translation>
    </message>
    <message>
        <source>Key of another station revoked</source>
        <translation>Schlüssel einer anderen Station widerrufen</translation>
    </message>
    <message>
        <source>Former key of another station kept</source>
        <translation>Früherer Schlüssel einer anderen Station behalten</translation>
    </message>
    <message>
        <source>Key of another station sealed as it was found</source>
        <translation>Schlüssel einer anderen Station versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>Named by another station’s records</source>
        <translation>Von Aufzeichnungen einer anderen Station genannt</translation>
    </message>
    <message>
        <source>Arrived from the office after others named it</source>
        <translation>Von der Zentrale eingetroffen, nachdem andere es genannt hatten</translation>
    </message>
    <message>
        <source>Name from another station sealed as it was found</source>
        <translation>Name von einer anderen Station versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>Attempt read in from another station</source>
        <translation>Versuch von einer anderen Station eingelesen</translation>
    </message>
    <message>
        <source>This is this station’s own.</source>
        <translation>Das gehört dieser Station selbst.</translation>
    </message>
    <message>
        <source>Only the office’s files bring accounts and assignments.</source>
        <translation>Nur Dateien der Zentrale bringen Konten und Zuweisungen.</translation>
    </message>
    <message>
        <source>This station is not trusted as the office here. Nothing was changed.</source>
        <translation>Dieser Station wird hier nicht als Zentrale vertraut. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This attempt belongs to another station.</source>
        <translation>Dieser Versuch gehört zu einer anderen Station.</translation>
    </message>
    <message>
        <source>This is no file of a station, or not as its station signed it.</source>
        <translation>Das ist keine Datei einer Station, oder nicht so, wie ihre Station sie signiert hat.</translation>
    </message>
    <message>
        <source>%1 was not read. Ask for it once more; nothing was changed.</source>
        <translation>%1 wurde nicht eingelesen. Fordern Sie die Datei noch einmal an; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>An older version of Cusp made this file.</source>
        <translation>Eine ältere Version von Cusp hat diese Datei erzeugt.</translation>
    </message>
    <message>
        <source>Update Cusp on the station that made %1, and ask for a new file. Nothing was changed.</source>
        <translation>Aktualisieren Sie Cusp auf der Station, die %1 erzeugt hat, und fordern Sie eine neue Datei an. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Nobody has made this station’s key known here.</source>
        <translation>Der Schlüssel dieser Station ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>This station’s key was revoked here.</source>
        <translation>Der Schlüssel dieser Station wurde hier widerrufen.</translation>
    </message>
    <message>
        <source>Key %1, station %2. Nothing was changed.</source>
        <translation>Schlüssel %1, Station %2. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This station was put back to an old copy.</source>
        <translation>Diese Station wurde auf eine alte Kopie zurückgesetzt.</translation>
    </message>
    <message>
        <source>The file says otherwise of something that is here already.</source>
        <translation>Die Datei sagt anderes über etwas, das schon hier ist.</translation>
    </message>
    <message>
        <source>Look at %1, %2. Nothing was changed.</source>
        <translation>Sehen Sie bei %1, %2 nach. Nichts wurde geändert.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercise(s)</source>
        <translation>
            <numerusform>%n Übung</numerusform>
            <numerusform>%n Übungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n assignment(s)</source>
        <translation>
            <numerusform>%n Zuweisung</numerusform>
            <numerusform>%n Zuweisungen</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>People, cohorts, assignments and exercises</source>
        <translation>Personen, Kohorten, Zuweisungen und Übungen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>office</source>
        <translation>Zentrale</translation>
    </message>
    <message>
        <source>former key</source>
        <translation>früherer Schlüssel</translation>
    </message>
    <message>
        <source>revoked</source>
        <translation>widerrufen</translation>
    </message>
    <message>
        <source>The file is read.</source>
        <translation>Die Datei ist eingelesen.</translation>
    </message>
    <message>
        <source>The file was read before.</source>
        <translation>Die Datei war schon eingelesen.</translation>
    </message>
    <message>
        <source>The file was made before one that was already read: it adds what is new and changes nothing.</source>
        <translation>Die Datei ist älter als eine schon eingelesene: Sie ergänzt Neues und ändert nichts.</translation>
    </message>
    <message>
        <source>New here: %1.</source>
        <translation>Neu hier: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n statement(s) wait for their attempt; read the file again after that of the other station.</source>
        <translation>
            <numerusform>%n Erklärung wartet auf ihren Versuch; lesen Sie die Datei nach der der anderen Station noch einmal ein.</numerusform>
            <numerusform>%n Erklärungen warten auf ihren Versuch; lesen Sie die Datei nach der der anderen Station noch einmal ein.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was changed here too; the office’s account counts.</source>
        <translation>%1 wurde auch hier geändert; das Konto der Zentrale gilt.</translation>
    </message>
    <message>
        <source>A newer version of Cusp made this file.</source>
        <translation>Eine neuere Version von Cusp hat diese Datei erstellt.</translation>
    </message>
    <message>
        <source>Update Cusp on this station, then read %1 again. Nothing was changed.</source>
        <translation>Aktualisieren Sie Cusp auf dieser Station und lesen Sie %1 dann erneut ein. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This file is not there.</source>
        <translation>Diese Datei ist nicht da.</translation>
    </message>
    <message>
        <source>After this file nobody could administer this station.</source>
        <translation>Nach dieser Datei könnte niemand mehr diese Station verwalten.</translation>
    </message>
    <message>
        <source>It switches off the last administrator here. Make another one first; nothing was changed.</source>
        <translation>Sie schaltet das letzte Verwaltungskonto hier aus. Legen Sie zuerst ein anderes an; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>A file of this name is there already.</source>
        <translation>Eine Datei dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>%1 stayed as it was. Choose another name.</source>
        <translation>%1 blieb, wie sie war. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1 belongs to somebody else here.</source>
        <translation>%1 gehört hier jemand anderem.</translation>
    </message>
    <message>
        <source>Change it here or in the office, and ask the office for a new file. Nothing was changed.</source>
        <translation>Ändern Sie das hier oder in der Zentrale, und bitten Sie die Zentrale um eine neue Datei. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is not there.</source>
        <translation>%1 ist nicht da.</translation>
    </message>
    <message>
        <source>%1 is no station’s key.</source>
        <translation>%1 ist kein Schlüssel einer Station.</translation>
    </message>
    <message>
        <source>Ask for the key once more. Nothing was changed.</source>
        <translation>Bitten Sie noch einmal um den Schlüssel. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Compare key %1 with that on the other station’s page, then make it known here. Station %2; nothing was changed.</source>
        <translation>Vergleichen Sie den Schlüssel %1 mit dem auf der Seite der anderen Station und machen Sie ihn dann hier bekannt. Station %2; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Recording of an attempt thinned</source>
        <translation>Aufzeichnung eines Versuchs ausgedünnt</translation>
    </message>
    <message>
        <source>Thinning of a recording sealed as it was found</source>
        <translation>Ausdünnung einer Aufzeichnung versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>Thinned recording came back in another station’s file</source>
        <translation>Ausgedünnte Aufzeichnung kam in einer Datei einer anderen Station zurück</translation>
    </message>
    <message>
        <source>Recordings are thinned after 1 to 36,500 days.</source>
        <translation>Aufzeichnungen werden nach 1 bis 36.500 Tagen ausgedünnt.</translation>
    </message>
    <message>
        <source>Accounts are kept for 1 to 100 years.</source>
        <translation>Konten werden 1 bis 100 Jahre aufbewahrt.</translation>
    </message>
    <message>
        <source>The recording was thinned on %1.</source>
        <translation>Die Aufzeichnung wurde am %1 ausgedünnt.</translation>
    </message>
    <message>
        <source>Grade, report and final tooth are kept. The attempt can no longer be replayed, graded again or packed for an appeal.</source>
        <translation>Bewertung, Bericht und fertiger Zahn sind erhalten. Der Versuch lässt sich nicht mehr wiedergeben, neu bewerten oder für einen Einspruch packen.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) would be thinned: %1.</source>
        <translation>
            <numerusform>%n Aufzeichnung würde ausgedünnt: %1.</numerusform>
            <numerusform>%n Aufzeichnungen würden ausgedünnt: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) were thinned: %1.</source>
        <translation>
            <numerusform>%n Aufzeichnung wurde ausgedünnt: %1.</numerusform>
            <numerusform>%n Aufzeichnungen wurden ausgedünnt: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Kept whole: %1.</source>
        <translation>Vollständig bleiben: %1.</translation>
    </message>
    <message>
        <source>%1 of another station</source>
        <translation>%1 einer anderen Station</translation>
    </message>
    <message>
        <source>%1 from assessments</source>
        <translation>%1 aus Prüfungen</translation>
    </message>
    <message>
        <source>%1 not finished</source>
        <translation>%1 nicht beendet</translation>
    </message>
    <message>
        <source>%1 without a grade</source>
        <translation>%1 ohne Bewertung</translation>
    </message>
    <message>
        <source>%1 that an examiner overrode, confirmed or released</source>
        <translation>%1, deren Ergebnis jemand geändert, bestätigt oder freigegeben hat</translation>
    </message>
    <message>
        <source>%1 that cannot be verified</source>
        <translation>%1 nicht nachweisbar unverändert</translation>
    </message>
    <message>
        <source>Adjustment of a student set</source>
        <translation>Nachteilsausgleich festgelegt</translation>
    </message>
    <message>
        <source>Adjustment of a student sealed as it was found</source>
        <translation>Nachteilsausgleich versiegelt, wie er vorgefunden wurde</translation>
    </message>
    <message>
        <source>A device has no such name.</source>
        <translation>So heißt kein Gerät.</translation>
    </message>
    <message>
        <source>This assignment needs another device.</source>
        <translation>Diese Zuweisung braucht ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Self-test of a device</source>
        <translation>Selbsttest eines Geräts</translation>
    </message>
    <message numerus="yes">
        <source>self-test at most %n day(s) old</source>
        <translation>
            <numerusform>Selbsttest höchstens %n Tag alt</numerusform>
            <numerusform>Selbsttest höchstens %n Tage alt</numerusform>
        </translation>
    </message>
    <message>
        <source>Ask the staff for a self-test of the %1 on the page Device.</source>
        <translation>Bitten Sie das Personal um einen Selbsttest auf der Seite Gerät (%1).</translation>
    </message>
    <message>
        <source>A self-test is 1 to 365 days old.</source>
        <translation>Ein Selbsttest ist 1 bis 365 Tage alt.</translation>
    </message>
    <message>
        <source>This assignment needs a newer self-test of the device.</source>
        <translation>Diese Zuweisung braucht einen neueren Selbsttest des Geräts.</translation>
    </message>
    <message>
        <source>It asks for a %1.</source>
        <translation>Sie verlangt: %1.</translation>
    </message>
    <message>
        <source>This exercise needs a device that senses %1 axes.</source>
        <translation>Diese Übung braucht ein Gerät, das %1 Achsen erfasst.</translation>
    </message>
    <message numerus="yes">
        <source>%n statement(s) about attempts</source>
        <translation>
            <numerusform>%n Erklärung zu Versuchen</numerusform>
            <numerusform>%n Erklärungen zu Versuchen</numerusform>
        </translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>partly met</source>
        <translation>teilweise erfüllt</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>zu tief</translation>
    </message>
    <message>
        <source>too shallow</source>
        <translation>zu flach</translation>
    </message>
    <message>
        <source>too wide</source>
        <translation>zu breit</translation>
    </message>
    <message>
        <source>a tilted wall</source>
        <translation>eine schräge Wand</translation>
    </message>
    <message>
        <source>undermined enamel</source>
        <translation>unterminierter Schmelz</translation>
    </message>
    <message>
        <source>a rough floor</source>
        <translation>ein rauer Boden</translation>
    </message>
    <message>
        <source>a thin marginal ridge</source>
        <translation>eine dünne Randleiste</translation>
    </message>
    <message>
        <source>an opened pulp</source>
        <translation>eine eröffnete Pulpa</translation>
    </message>
    <message>
        <source>a nicked neighbour</source>
        <translation>ein verletzter Nachbarzahn</translation>
    </message>
    <message>
        <source>a contact left closed</source>
        <translation>ein geschlossener Kontakt</translation>
    </message>
    <message>
        <source>caries left at the periphery</source>
        <translation>Karies an der Peripherie belassen</translation>
    </message>
    <message>
        <source>sound tissue excavated</source>
        <translation>gesundes Gewebe exkaviert</translation>
    </message>
    <message>
        <source>the wrong bur</source>
        <translation>der falsche Bohrer</translation>
    </message>
    <message>
        <source>a trembling hand</source>
        <translation>eine zitternde Hand</translation>
    </message>
    <message>
        <source>cutting without water</source>
        <translation>Bohren ohne Wasser</translation>
    </message>
    <message>
        <source>Reference operator with one fault: %1, %2</source>
        <extracomment>%1: a fault (&quot;too deep&quot;), %2: its size (&quot;0.9 mm&quot;)</extracomment>
        <translation>Referenzoperateur mit einem Fehler: %1, %2</translation>
    </message>
    <message>
        <source>%1 is no name of a target: a letter, then letters, digits and _, all small.</source>
        <translation>%1 ist kein Name eines Ziels: ein Buchstabe, dann Buchstaben, Ziffern und _, alles klein.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a measurement of one of several targets</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No tooth was found that suits this exercise.</source>
        <translation>Es wurde kein Zahn gefunden, der sich für diese Übung eignet.</translation>
    </message>
    <message>
        <source>Tell the invigilator. No attempt was started or counted (%1).</source>
        <translation>Sagen Sie es der Aufsicht. Es wurde kein Versuch begonnen oder gezählt (%1).</translation>
    </message>
    <message>
        <source>another tooth for each candidate</source>
        <translation>für alle ein anderer Zahn</translation>
    </message>
    <message>
        <source>Only an assessment draws a tooth for each candidate.</source>
        <translation>Nur eine Prüfung lost für jede und jeden einen eigenen Zahn.</translation>
    </message>
    <message>
        <source>The records are damaged.</source>
        <translation>Die Aufzeichnungen sind beschädigt.</translation>
    </message>
    <message>
        <source>What is whole can be read and exported. Nothing can be drilled or changed until a backup takes their place.</source>
        <translation>Was unversehrt ist, kann gelesen und exportiert werden. Gebohrt oder geändert wird nichts, bis eine Sicherung an ihre Stelle tritt.</translation>
    </message>
    <message>
        <source>Tooth warmer by</source>
        <translation>Zahn wärmer um</translation>
    </message>
    <message>
        <source>The tooth was overheated by cutting dry</source>
        <translation>Der Zahn wurde durch Bohren ohne Kühlung überhitzt</translation>
    </message>
    <message>
        <source>Margin below 80° or above 110°</source>
        <translation>Rand unter 80° oder über 110°</translation>
    </message>
    <message>
        <source>The backup is damaged.</source>
        <translation>Die Sicherung ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 holds another number of attempts than its description. Nothing was changed; restore another backup.</source>
        <translation>%1 enthält eine andere Anzahl Versuche als in der Beschreibung angegeben. Nichts wurde geändert; stellen Sie eine andere Sicherung wieder her.</translation>
    </message>
    <message>
        <source>Counts for %1, because target is left</source>
        <translation>Zählt zu %1, weil vom Ziel etwas stehen blieb</translation>
    </message>
    <message>
        <source>The rest counts for less where its own target is left, the least of it for %1.</source>
        <translation>Das Übrige zählt weniger, wo von seinem eigenen Ziel etwas stehen blieb, am wenigsten zu %1.</translation>
    </message>
    <message>
        <source>The rest counts for %1, because target is left.</source>
        <translation>Das Übrige zählt zu %1, weil vom Ziel etwas stehen blieb.</translation>
    </message>
    <message>
        <source>Widen the outline until the bur passes freely.</source>
        <translation>Umriss erweitern, bis der Bohrer frei hindurchgeht.</translation>
    </message>
    <message>
        <source>This attempt is being drilled in another window.</source>
        <translation>Dieser Versuch wird gerade in einem anderen Fenster bearbeitet.</translation>
    </message>
    <message>
        <source>It opens as soon as it has ended.</source>
        <translation>Er lässt sich öffnen, sobald er beendet ist.</translation>
    </message>
    <message>
        <source>At %1 its cells are not evenly spaced, or not between 0.005 and 5 mm.</source>
        <translation>Bei %1 sind die Zellen nicht gleich groß oder nicht zwischen 0,005 und 5 mm groß.</translation>
    </message>
    <message>
        <source>%1 holds nothing solid. Check its unit, and which grey values are tissue.</source>
        <translation>%1 enthält nichts Festes. Prüfen Sie die Einheit und welche Grauwerte Gewebe sind.</translation>
    </message>
    <message>
        <source>Assignment withdrawn</source>
        <translation>Zuweisung zurückgezogen</translation>
    </message>
    <message>
        <source>Withdrawal of an assignment sealed as it was found</source>
        <translation>Zurückgezogene Zuweisung versiegelt, wie sie vorgefunden wurde</translation>
    </message>
    <message>
        <source>This assignment was withdrawn.</source>
        <translation>Diese Zuweisung wurde zurückgezogen.</translation>
    </message>
    <message>
        <source>Widen the box until the margin stands far enough from the neighbour.</source>
        <translation>Den Kasten erweitern, bis der Rand weit genug vom Nachbarn entfernt ist.</translation>
    </message>
    <message>
        <source>%1 after %2</source>
        <extracomment>A critical event, and when it happened in the attempt: &quot;The pulp was exposed after 1:12 min&quot;.</extracomment>
        <translation>%1 nach %2</translation>
    </message>
    <message>
        <source>Take more time: read depth and walls before you end the attempt.</source>
        <translation>Nehmen Sie sich mehr Zeit: Prüfen Sie Tiefe und Wände, bevor Sie den Versuch beenden.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>An older version of Cusp ended this attempt without a grade, so it cannot be continued.</source>
        <translation>Eine ältere Version von Cusp hat diesen Versuch ohne Bewertung beendet; fortgesetzt werden kann er nicht.</translation>
    </message>
    <message>
        <source>It can be graded as it stands.</source>
        <translation>Er kann bewertet werden, wie er ist.</translation>
    </message>
    <message>
        <source>No bur of the exercise fits into its target while the handpiece is tilted by %1.</source>
        <translation>Kein Bohrer der Übung passt in ihr Ziel, wenn das Handstück um %1 geneigt ist.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>ja oder nein</translation>
    </message>
    <message>
        <source>%1; full points for %2</source>
        <extracomment>Of a measurement that is &quot;yes&quot; or &quot;no&quot;: what it is, and what earns full points.</extracomment>
        <translation>%1; volle Punktzahl bei %2</translation>
    </message>
    <message>
        <source>Contact open</source>
        <translation>Kontakt offen</translation>
    </message>
    <message>
        <source>This computer’s clock says %1. The newest attempt or account is of %2.</source>
        <translation>Die Uhr dieses Computers zeigt den %1. Der neueste Versuch oder das neueste Konto ist vom %2.</translation>
    </message>
    <message>
        <source>The clock may be wrong.</source>
        <translation>Die Uhr geht vielleicht falsch.</translation>
    </message>
    <message>
        <source>If that date is wrong, cancel and set the clock.</source>
        <translation>Wenn dieses Datum nicht stimmt, brechen Sie ab und stellen Sie die Uhr.</translation>
    </message>
    <message>
        <source>Your account is switched off.</source>
        <translation>Ihr Konto ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The driver of the device stands still.</source>
        <translation>Der Treiber des Geräts steht still.</translation>
    </message>
    <message>
        <source>%1: unplug it and plug it in again.</source>
        <translation>%1: Stecken Sie es aus und schließen Sie es wieder an.</translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 Punkt</numerusform>
            <numerusform>%1 Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>This version of the exercise was withdrawn.</source>
        <translation>Diese Version der Übung wurde zurückgezogen.</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Höchste Kraft</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>Mittlere Kraft</translation>
    </message>
    <message>
        <source>The pulp was exposed</source>
        <translation>Die Pulpa wurde eröffnet</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) went on from an old copy at the station, and stay here as they were.</source>
        <translation>
            <numerusform>%n Versuch ging an der Station von einer alten Kopie aus weiter und bleibt hier, wie er war.</numerusform>
            <numerusform>%n Versuche gingen an der Station von einer alten Kopie aus weiter und bleiben hier, wie sie waren.</numerusform>
        </translation>
    </message>
    <message>
        <source>An earlier file of this name was interrupted.</source>
        <translation>Das Schreiben einer früheren Datei dieses Namens wurde unterbrochen.</translation>
    </message>
    <message>
        <source>%1 is now finished. Choose another name for a newer one.</source>
        <translation>%1 ist jetzt fertig. Wählen Sie für eine neuere Datei einen anderen Namen.</translation>
    </message>
    <message>
        <source>The log of other records lies there.</source>
        <translation>Dort liegt das Schreibprotokoll anderer Daten.</translation>
    </message>
    <message>
        <source>%1 belongs to records that were moved away. Move it beside them, or choose another place with --db.</source>
        <translation>%1 gehört zu Daten, die verschoben wurden. Legen Sie die Datei neben diese, oder wählen Sie mit --db einen anderen Ort.</translation>
    </message>
    <message>
        <source>The result was changed at another desk meanwhile.</source>
        <translation>Das Ergebnis wurde inzwischen an einem anderen Platz geändert.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>This is your own attempt.</source>
        <translation>Dies ist Ihr eigener Versuch.</translation>
    </message>
    <message>
        <source>Another examiner marks and releases it. Nothing was changed.</source>
        <translation>Eine andere Lehrkraft bewertet ihn und gibt ihn frei. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The Inverse3 was not found.</source>
        <translation>Das Inverse3 wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>Its service answers, but it knows of no Inverse3. Check its cable and power, then try again.</source>
        <translation>Sein Dienst antwortet, kennt aber kein Inverse3. Prüfen Sie Kabel und Strom und versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>The service of the Inverse3 does not answer.</source>
        <translation>Der Dienst des Inverse3 antwortet nicht.</translation>
    </message>
    <message>
        <source>Start the maker’s service on this computer, then try again.</source>
        <translation>Starten Sie den Dienst des Herstellers auf diesem Computer und versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>The Inverse3 did not start.</source>
        <translation>Das Inverse3 ist nicht gestartet.</translation>
    </message>
    <message>
        <source>Start the maker’s service anew, then try again. (%1)</source>
        <translation>Starten Sie den Dienst des Herstellers neu und versuchen Sie es dann noch einmal. (%1)</translation>
    </message>
    <message>
        <source>The station’s key is damaged: put its file back from a backup.</source>
        <translation>Der Schlüssel der Station ist beschädigt: Legen Sie seine Datei aus einer Sicherung zurück.</translation>
    </message>
    <message>
        <source>%1 cannot be read; the records are as they were. Without a backup move it away: Cusp then makes a new key, which other stations have to trust anew.</source>
        <translation>%1 ist nicht lesbar; die Aufzeichnungen sind, wie sie waren. Ohne Sicherung verschieben Sie die Datei: Cusp erzeugt dann einen neuen Schlüssel, dem andere Stationen neu vertrauen müssen.</translation>
    </message>
    <message>
        <source>This computer’s clock says %1. Nothing was recorded from %2 to %3. If the clock is wrong now, or was before, attempts and accounts are younger than their dates.</source>
        <translation>Die Uhr dieses Computers zeigt den %1. Vom %2 bis zum %3 wurde nichts aufgezeichnet. Wenn die Uhr jetzt falsch geht oder vorher falsch ging, sind Versuche und Konten jünger als ihr Datum.</translation>
    </message>
    <message>
        <source>If one of these dates is wrong, cancel.</source>
        <translation>Wenn eine dieser Datumsangaben falsch ist, brechen Sie ab.</translation>
    </message>
    <message>
        <source>Lower the gingival floor until its margin stands clear of the neighbour.</source>
        <translation>Den gingivalen Boden absenken, bis sein Rand frei vom Nachbarn steht.</translation>
    </message>
    <message>
        <source>Keep the gingival floor higher: its margin lies far from the neighbour.</source>
        <translation>Den gingivalen Boden höher lassen: Sein Rand liegt weit vom Nachbarn entfernt.</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) exported.</source>
        <translation>
            <numerusform>%n Ergebnis exportiert.</numerusform>
            <numerusform>%n Ergebnisse exportiert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them failed by a critical event with enough points to pass: the gradebook sees the points alone.</source>
        <translation>
            <numerusform>%n davon ist trotz ausreichender Punkte wegen eines kritischen Ereignisses nicht bestanden: Das Notenbuch sieht nur die Punkte.</numerusform>
            <numerusform>%n davon sind trotz ausreichender Punkte wegen eines kritischen Ereignisses nicht bestanden: Das Notenbuch sieht nur die Punkte.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) wait for release.</source>
        <translation>
            <numerusform>%n Ergebnis wartet auf die Freigabe.</numerusform>
            <numerusform>%n Ergebnisse warten auf die Freigabe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) have no graded attempt: %1.</source>
        <translation>
            <numerusform>%n Person hat keinen bewerteten Versuch: %1.</numerusform>
            <numerusform>%n Studierende haben keinen bewerteten Versuch: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 refused. The Device page shows the line that permits it.</source>
        <translation>%1 lehnte ab. Die Seite Gerät zeigt die Zeile, die es erlaubt.</translation>
    </message>
    <message>
        <source>Connected is: %1. No attempt was started. Staff choose the device on the page Device.</source>
        <translation>Verbunden ist: %1. Kein Versuch wurde begonnen. Das Personal wählt das Gerät auf der Seite Gerät.</translation>
    </message>
    <message>
        <source>The attempt ended as interrupted. What was recorded until then is kept: continue it, or have it graded as it stands. Before that, unplug %1 and plug it in again.</source>
        <translation>Der Versuch endete als unterbrochen. Was bis dahin aufgezeichnet wurde, ist gesichert: Setzen Sie ihn fort, oder lassen Sie ihn bewerten, wie er ist. Ziehen Sie vorher das Gerät ab (%1) und stecken Sie es wieder ein.</translation>
    </message>
    <message>
        <source>%1: there is no self-test. Ask the staff to choose another device on the page Device.</source>
        <translation>%1: Es gibt keinen Selbsttest. Bitten Sie das Personal, auf der Seite Gerät ein anderes Gerät zu wählen.</translation>
    </message>
    <message>
        <source>The start page shows when it opens.</source>
        <translation>Die Startseite zeigt, wann sie öffnet.</translation>
    </message>
    <message>
        <source>Admitted: %1. In use: %2. Ask the staff to choose another one on the page Device.</source>
        <translation>Zugelassen: %1. In Gebrauch: %2. Bitten Sie das Personal, auf der Seite Gerät ein anderes zu wählen.</translation>
    </message>
    <message>
        <source>Erase at the office instead: its next file erases them here, too. Attempts at other stations do not count here, and who is erased here stays so, also if the office’s next file brings the account.</source>
        <translation>Löschen Sie stattdessen in der Zentrale: Deren nächste Datei löscht sie auch hier. Versuche an anderen Stationen zählen hier nicht, und wer hier gelöscht ist, bleibt es, auch wenn die nächste Datei der Zentrale das Konto bringt.</translation>
    </message>
    <message>
        <source>Attempts at other stations count once their files are read in: read the newest ones first.</source>
        <translation>Versuche an anderen Stationen zählen, sobald deren Dateien eingelesen sind: Lesen Sie zuerst die neuesten ein.</translation>
    </message>
    <message>
        <source>This computer’s clock is behind.</source>
        <translation>Die Uhr dieses Computers geht nach.</translation>
    </message>
    <message>
        <source>It shows %1, and the newest attempt is of %2. Set it before anybody drills: the order of attempts and what is assigned follow it.</source>
        <translation>Sie zeigt %1, und der neueste Versuch ist vom %2. Stellen Sie sie, bevor jemand bohrt: Die Reihenfolge der Versuche und was zugewiesen ist, richten sich nach ihr.</translation>
    </message>
    <message>
        <source>Station %1 has given out another file under number %2 before. Close Cusp there, move its file that ends in .key away, and start Cusp: it makes a new key. Make that known here; nothing was changed.</source>
        <translation>Station %1 hat unter Nummer %2 schon eine andere Datei ausgegeben. Schließen Sie dort Cusp, verschieben Sie die Datei, deren Name auf .key endet, in einen anderen Ordner und starten Sie Cusp: Es erstellt einen neuen Schlüssel. Machen Sie diesen hier bekannt; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This file cannot be used.</source>
        <translation>Diese Datei kann nicht verwendet werden.</translation>
    </message>
    <message>
        <source>In %1 the tissue %2 has the code of a grown tooth’s: 29 and 30 are a neighbour’s, 31 is firm caries. Give it one from 16 to 28.</source>
        <translation>In %1 hat das Gewebe %2 die Nummer eines Gewebes erzeugter Zähne: 29 und 30 gehören einem Nachbarzahn, 31 ist feste Karies. Geben Sie ihm eine von 16 bis 28.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) that were here have gone on.</source>
        <translation>
            <numerusform>%n Versuch, der schon hier war, ist weitergegangen.</numerusform>
            <numerusform>%n Versuche, die schon hier waren, sind weitergegangen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) made here gave the number to the office’s account of the same name; People shows both.</source>
        <translation>
            <numerusform>%n hier angelegtes Konto hat die Nummer dem Konto der Zentrale mit demselben Namen überlassen; Personen zeigt beide.</numerusform>
            <numerusform>%n hier angelegte Konten haben die Nummer den Konten der Zentrale mit denselben Namen überlassen; Personen zeigt beide.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no such folder.</source>
        <translation>Diesen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 was not written. Choose another place.</source>
        <translation>%1 wurde nicht geschrieben. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>This file cannot be opened.</source>
        <translation>Diese Datei kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>%1, its folder or its drive does not admit it. Nothing was changed.</source>
        <translation>%1, der Ordner oder das Laufwerk lässt es nicht zu. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The file is too large.</source>
        <translation>Die Datei ist zu groß.</translation>
    </message>
    <message>
        <source>Nothing of the last step was written to %1; all before it is kept. A drive formatted as FAT32 takes no file above 4 GB.</source>
        <translation>Vom letzten Schritt wurde nichts in %1 geschrieben; alles davor ist aufbewahrt. Ein mit FAT32 formatiertes Laufwerk nimmt keine Datei über 4 GB auf.</translation>
    </message>
    <message>
        <source>%1 stayed as it was. Another window of Cusp holds it while it reads in a file of another station: wait until that is done, or close the other program, and try again.</source>
        <translation>%1 blieb, wie es war. Ein anderes Fenster von Cusp hält es, während es eine Datei einer anderen Station einliest: Warten Sie, bis das fertig ist, oder schließen Sie das andere Programm, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>This file is cut short.</source>
        <translation>Diese Datei ist abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 of the %2 bytes of %3 are there. Copy it here once more; a drive formatted as FAT32 takes no file above 4 GB. Nothing was changed.</source>
        <translation>Von %3 sind %1 der %2 Bytes da. Kopieren Sie sie noch einmal hierher; ein mit FAT32 formatiertes Laufwerk nimmt keine Datei über 4 GB auf. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The folder for backups cannot be written.</source>
        <translation>In den Ordner für Sicherungen kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>%1: %2. Connect its drive, or choose another folder. The records are as they were.</source>
        <translation>%1: %2. Schließen Sie das Laufwerk an, oder wählen Sie einen anderen Ordner. Die Aufzeichnungen sind, wie sie waren.</translation>
    </message>
    <message>
        <source>The drive for backups is full.</source>
        <translation>Das Laufwerk für Sicherungen ist voll.</translation>
    </message>
    <message>
        <source>%1 has no room for a copy of the records. Free some space there, or choose another folder.</source>
        <translation>%1 hat keinen Platz für eine Kopie der Aufzeichnungen. Schaffen Sie dort Platz, oder wählen Sie einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TextsForm</name>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>Expected time</source>
        <translation>Erwartete Zeit</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <extracomment>%1: a language</extracomment>
        <translation>Titel, %1</translation>
    </message>
    <message>
        <source>Briefing, %1</source>
        <extracomment>%1: a language</extracomment>
        <translation>Aufgabe, %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Add a language…</source>
        <translation>Sprache hinzufügen …</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Sprache hinzufügen</translation>
    </message>
    <message>
        <source>Name of target %1, %2</source>
        <extracomment>%1: which of several targets, %2: a language</extracomment>
        <translation>Name von Ziel %1, %2</translation>
    </message>
    <message>
        <source>%1 of at most %2 characters. The exercise keeps the briefing as it was.</source>
        <extracomment>%1: characters of a text, %2: the most that an exercise can hold</extracomment>
        <translation>%1 von höchstens %2 Zeichen. Die Übung behält die Aufgabe, wie sie war.</translation>
    </message>
    <message>
        <source>An exercise needs a briefing in English. It keeps the one from before until another is typed.</source>
        <translation>Eine Übung braucht eine Aufgabe auf Englisch. Sie behält die bisherige, bis eine andere eingegeben ist.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TissuesForm</name>
    <message>
        <source>set for this exercise</source>
        <translation>für diese Übung gesetzt</translation>
    </message>
    <message>
        <source>usual, not verified</source>
        <translation>üblich, nicht geprüft</translation>
    </message>
    <message>
        <source>usual, from the published method</source>
        <translation>üblich, aus dem veröffentlichten Verfahren</translation>
    </message>
    <message>
        <source>usual, by hardness (Chun 2014)</source>
        <translation>üblich, nach Härte (Chun 2014)</translation>
    </message>
    <message>
        <source>usual, from %1</source>
        <translation>üblich, aus %1</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>Handstück</translation>
    </message>
    <message>
        <source>Any: speed is not reckoned</source>
        <translation>Beliebig: Drehzahl zählt nicht</translation>
    </message>
    <message>
        <source>Turbine</source>
        <translation>Turbine</translation>
    </message>
    <message>
        <source>Electric</source>
        <translation>Elektrisch</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>Bur vibrates in the hand</source>
        <translation>Bohrer vibriert in der Hand</translation>
    </message>
    <message>
        <source>Drilling sound</source>
        <translation>Bohrgeräusch</translation>
    </message>
    <message>
        <source>Coolant and heat</source>
        <translation>Kühlung und Wärme</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>How handpieces give way, tremble and warm a tooth is general knowledge, not verified.</source>
        <translation>Wie Handstücke nachgeben, zittern und einen Zahn erwärmen, ist allgemeines Wissen, nicht geprüft.</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Steifigkeit: %1</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Removal speed of %1</source>
        <translation>Abtragsgeschwindigkeit: %1</translation>
    </message>
    <message>
        <source>Removal speed</source>
        <translation>Abtrag</translation>
    </message>
    <message>
        <source>Tilt of the handpiece</source>
        <translation>Neigung des Handstücks</translation>
    </message>
    <message>
        <source>From vertical; above 0 the shank leans towards buccal</source>
        <translation>Von der Senkrechten; über 0 neigt sich der Schaft nach bukkal</translation>
    </message>
    <message>
        <source>Tilt at rest</source>
        <translation>Neigung in Ruhe</translation>
    </message>
    <message>
        <source>Turn of the handpiece</source>
        <translation>Drehung des Handstücks</translation>
    </message>
    <message>
        <source>How far the student may turn the handpiece from its tilt at rest; 0: not at all</source>
        <translation>Wie weit Studierende das Handstück aus seiner Neigung in Ruhe drehen dürfen; 0: gar nicht</translation>
    </message>
    <message>
        <source>Turn from there</source>
        <translation>Drehung von dort aus</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ToothForm</name>
    <message>
        <source>Central pit</source>
        <translation>Zentrale Grube</translation>
    </message>
    <message>
        <source>Mesial pit</source>
        <translation>Mesiale Grube</translation>
    </message>
    <message>
        <source>Distal pit</source>
        <translation>Distale Grube</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>Mesial</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>Distal</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>Bukkal</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>Lingual</translation>
    </message>
    <message>
        <source>Plastic, as a training model</source>
        <translation>Kunststoff zum Üben</translation>
    </message>
    <message>
        <source>Round the tooth</source>
        <translation>Um den Zahn</translation>
    </message>
    <message>
        <source>Neighbouring teeth</source>
        <translation>Nachbarzähne</translation>
    </message>
    <message>
        <source>Gums</source>
        <translation>Gingiva</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>The rest of the jaw</source>
        <translation>Der übrige Kiefer</translation>
    </message>
    <message>
        <source>To look at: only the tooth, its neighbours and what lies about them can be drilled</source>
        <translation>Zum Ansehen: Gebohrt werden nur der Zahn, seine Nachbarn und was um sie liegt</translation>
    </message>
    <message>
        <source>In a fissure</source>
        <translation>In einer Fissur</translation>
    </message>
    <message>
        <source>Between teeth</source>
        <translation>Zwischen Zähnen</translation>
    </message>
    <message>
        <source>On the root</source>
        <translation>An der Wurzel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Depth in dentine</source>
        <translation>Tiefe im Dentin</translation>
    </message>
    <message>
        <source>Carious lesions</source>
        <translation>Kariöse Läsionen</translation>
    </message>
    <message>
        <source>Add a carious lesion</source>
        <translation>Kariöse Läsion hinzufügen</translation>
    </message>
    <message>
        <source>How caries spreads, and how gums and bone lie, is general knowledge, not verified.</source>
        <translation>Wie Karies sich ausbreitet und wie Gingiva und Knochen liegen, ist allgemeines Wissen, nicht geprüft.</translation>
    </message>
    <message>
        <source>Kind of carious lesion %1</source>
        <translation>Art der kariösen Läsion %1</translation>
    </message>
    <message>
        <source>Place of carious lesion %1</source>
        <translation>Ort der kariösen Läsion %1</translation>
    </message>
    <message>
        <source>Remove carious lesion %1</source>
        <translation>Kariöse Läsion %1 entfernen</translation>
    </message>
    <message>
        <source>Width of carious lesion %1</source>
        <translation>Breite der kariösen Läsion %1</translation>
    </message>
    <message>
        <source>Depth of carious lesion %1</source>
        <translation>Tiefe der kariösen Läsion %1</translation>
    </message>
    <message>
        <source>Softness of carious lesion %1</source>
        <translation>Weichheit der kariösen Läsion %1</translation>
    </message>
    <message>
        <source>How far from its middle to its rim the lesion is soft; the rest is firm</source>
        <translation>Wie weit die Läsion von der Mitte zum Rand weich ist; der Rest ist fest</translation>
    </message>
</context>
<context>
    <name>cusp::ui::ToothView</name>
    <message>
        <source>The tooth is drawn where the screen has OpenGL.</source>
        <translation>Der Zahn erscheint dort, wo der Bildschirm OpenGL hat.</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>The tooth could not be drawn: %1</source>
        <translation>Der Zahn konnte nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>3D pictures are off: this station can grade, replay and administer.</source>
        <translation>3D-Bilder sind aus: Diese Station kann bewerten, wiedergeben und verwalten.</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TrimForm</name>
    <message>
        <source>held by the clutch</source>
        <translation>von der Kupplung gehalten</translation>
    </message>
    <message>
        <source>Of the hand&apos;s way</source>
        <translation>Vom Weg der Hand</translation>
    </message>
    <message>
        <source>Force: asked over felt</source>
        <translation>Kraft: verlangt durch gespürt</translation>
    </message>
    <message>
        <source>Top button</source>
        <translation>Obere Taste</translation>
    </message>
    <message>
        <source>Left button, which then changes no bur</source>
        <translation>Linke Taste, die dann keinen Bohrer wechselt</translation>
    </message>
    <message>
        <source>Right button, which then changes no bur</source>
        <translation>Rechte Taste, die dann keinen Bohrer wechselt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Clutch: the grip moves, the bur stays</source>
        <translation>Kupplung: der Griff bewegt sich, der Bohrer bleibt</translation>
    </message>
    <message>
        <source>Force: 2 N asked for and 1.6 N on a spring scale are 125 %. Measure it before a change, and run the self-test again after it.</source>
        <translation>Kraft: 2 N verlangt und 1,6 N an der Federwaage sind 125 %. Vor einer Änderung messen, danach den Selbsttest noch einmal machen.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The usual values</source>
        <translation>Die üblichen Werte</translation>
    </message>
    <message>
        <source>right %1, up %2, nearer %3</source>
        <extracomment>Three lengths: right, up and towards the user.</extracomment>
        <translation>rechts %1, oben %2, näher %3</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation>Näher</translation>
    </message>
    <message>
        <source>As it stands now</source>
        <translation>Wie er jetzt steht</translation>
    </message>
    <message>
        <source>Bur, from where an attempt begins</source>
        <translation>Bohrer, vom Beginn eines Versuchs aus</translation>
    </message>
    <message>
        <source>Where the grip stands when an attempt begins, from the middle of its travel:</source>
        <translation>Wo der Griff zu Beginn eines Versuchs steht, von der Mitte seines Weges aus:</translation>
    </message>
</context>
<context>
    <name>cusp::ui::TrustCard</name>
    <message>
        <source>A known station</source>
        <translation>Eine bekannte Station</translation>
    </message>
    <message>
        <source>Make a station known</source>
        <translation>Station bekannt machen</translation>
    </message>
    <message>
        <source>Fingerprint of its key</source>
        <translation>Fingerabdruck ihres Schlüssels</translation>
    </message>
    <message>
        <source>Fingerprint of the key in this file</source>
        <translation>Fingerabdruck des Schlüssels in dieser Datei</translation>
    </message>
    <message>
        <source>Fingerprint %1</source>
        <translation>Fingerabdruck %1</translation>
    </message>
    <message>
        <source>Call the other station’s administrator, who sees its fingerprint on the page Other stations and reads it to you. Only if every sign is the same, the file is truly from there.</source>
        <translation>Rufen Sie die Verwaltung der anderen Station an; sie sieht ihren Fingerabdruck auf der Seite Andere Stationen und liest ihn vor. Nur wenn jedes Zeichen gleich ist, kommt die Datei wirklich von dort.</translation>
    </message>
    <message>
        <source>This key was revoked: none of its files is read. Made known again, they are.</source>
        <translation>Dieser Schlüssel wurde widerrufen: Keine seiner Dateien wird eingelesen. Machen Sie ihn wieder bekannt, werden sie wieder eingelesen.</translation>
    </message>
    <message>
        <source>A former key: it signed older records of this station. Made known again, its files are read too.</source>
        <translation>Ein früherer Schlüssel: Er signierte ältere Aufzeichnungen dieser Station. Wieder bekannt gemacht, werden auch seine Dateien eingelesen.</translation>
    </message>
    <message>
        <source>Clinic, room 2</source>
        <translation>Klinik, Raum 2</translation>
    </message>
    <message>
        <source>What you call it here</source>
        <translation>Ihr Name für sie</translation>
    </message>
    <message>
        <source>A station</source>
        <translation>Eine Station</translation>
    </message>
    <message>
        <source>The office</source>
        <translation>Die Zentrale</translation>
    </message>
    <message>
        <source>It is</source>
        <translation>Sie ist</translation>
    </message>
    <message>
        <source>Its files bring people, cohorts, assignments and exercises, and its results.</source>
        <translation>Ihre Dateien bringen Personen, Kohorten, Zuweisungen und Übungen sowie ihre Ergebnisse.</translation>
    </message>
    <message>
        <source>Its files bring its results alone.</source>
        <translation>Ihre Dateien bringen nur ihre Ergebnisse.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>It is the same: make it known</source>
        <translation>Er ist gleich: bekannt machen</translation>
    </message>
</context>
<context>
    <name>cusp::ui::VolumeForm</name>
    <message>
        <source>This is a specimen of Cusp’s own: it is taken as it stands.</source>
        <translation>Das ist ein Präparat von Cusp selbst: Es wird übernommen, wie es ist.</translation>
    </message>
    <message>
        <source>Only the largest component</source>
        <translation>Nur die größte Komponente</translation>
    </message>
    <message>
        <source>Closed hollows are pulp</source>
        <translation>Geschlossene Hohlräume sind Pulpa</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>What %1 is made of</source>
        <translation>Woraus %1 besteht</translation>
    </message>
    <message numerus="yes">
        <source>%n voxel(s)</source>
        <translation>
            <numerusform>%n Voxel</numerusform>
            <numerusform>%n Voxel</numerusform>
        </translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>Nicht benutzt</translation>
    </message>
    <message>
        <source>Tissue of range %1</source>
        <translation>Gewebe von Bereich %1</translation>
    </message>
    <message>
        <source>Nothing: left out</source>
        <translation>Nichts: weggelassen</translation>
    </message>
    <message>
        <source>Least value of range %1</source>
        <translation>Kleinster Wert von Bereich %1</translation>
    </message>
    <message>
        <source>from</source>
        <translation>ab</translation>
    </message>
</context>
<context>
    <name>cusp::ui::WayBack</name>
    <message>
        <source>Go back to a backup</source>
        <translation>Zu einer Sicherung zurück</translation>
    </message>
    <message>
        <source>Go back to this backup</source>
        <translation>Zu dieser Sicherung zurück</translation>
    </message>
    <message>
        <source>Look in another folder</source>
        <translation>In einem anderen Ordner suchen</translation>
    </message>
    <message>
        <source>Try the records again</source>
        <translation>Aufzeichnungen erneut öffnen</translation>
    </message>
    <message>
        <source>There is no backup in %1.</source>
        <translation>In %1 liegt keine Sicherung.</translation>
    </message>
    <message numerus="yes">
        <source>%n backup(s) in %1.</source>
        <translation>
            <numerusform>%n Sicherung in %1.</numerusform>
            <numerusform>%n Sicherungen in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a folder with backups</source>
        <translation>Ordner mit Sicherungen wählen</translation>
    </message>
    <message>
        <source>Go back to the backup of %1?</source>
        <translation>Zur Sicherung vom %1 zurück?</translation>
    </message>
    <message numerus="yes">
        <source>It holds %n session(s). No other Cusp may run with these records.</source>
        <translation>
            <numerusform>Sie enthält %n Versuch. Kein anderes Cusp darf mit diesen Aufzeichnungen laufen.</numerusform>
            <numerusform>Sie enthält %n Versuche. Kein anderes Cusp darf mit diesen Aufzeichnungen laufen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück zur Sicherung</translation>
    </message>
    <message>
        <source>Checking and copying the backup</source>
        <translation>Die Sicherung wird geprüft und kopiert</translation>
    </message>
    <message>
        <source>The backup was not put in place.</source>
        <translation>Die Sicherung wurde nicht eingesetzt.</translation>
    </message>
    <message>
        <source>The records are those of %1.</source>
        <translation>Die Aufzeichnungen sind die vom %1.</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Those of other stations stand last.</source>
        <translation>Sicherungen anderer Stationen stehen am Ende.</translation>
    </message>
    <message>
        <source>It is of another station, whose records take the place of these.</source>
        <translation>Sie stammt von einer anderen Station, deren Aufzeichnungen an die Stelle der hiesigen treten.</translation>
    </message>
    <message>
        <source>A backup can take the place of the records. The files that stand there now are moved to a folder beside them; nothing is deleted or overwritten. Attempts after the backup stay in that folder alone.</source>
        <translation>Eine Sicherung kann an die Stelle der Aufzeichnungen treten. Die Dateien, die jetzt dort liegen, kommen in einen Ordner daneben; nichts wird gelöscht oder überschrieben. Versuche nach der Sicherung bleiben nur in diesem Ordner.</translation>
    </message>
    <message>
        <source>%1 is being read.</source>
        <translation>%1 wird gelesen.</translation>
    </message>
    <message>
        <source>What stood there before is kept in %1.</source>
        <translation>Was vorher dort lag, liegt jetzt in %1.</translation>
    </message>
</context>
</TS>

#include "compare/report.hpp"

#include "compare/html_text.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <regex>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsNan;
using ::testing::Not;
using ::testing::SizeIs;

const double kNone = std::nan("");

TEST(Metric, HoldsWithinItsLimits) {
  EXPECT_TRUE((Metric{.name = "a", .value = 1.0, .upper = 1.0}.holds()));
  EXPECT_FALSE((Metric{.name = "a", .value = 1.0001, .upper = 1.0}.holds()));
  EXPECT_TRUE((Metric{.name = "a", .value = 1.0, .lower = 1.0}.holds()));
  EXPECT_FALSE((Metric{.name = "a", .value = 0.9, .lower = 1.0, .upper = 2.0}.holds()));
  EXPECT_FALSE((Metric{.name = "a", .value = kNone, .upper = 1.0}.holds()));
  EXPECT_FALSE((Metric{.name = "a", .value = kNone}.holds()));
  EXPECT_FALSE((Metric{.name = "a", .value = 1.0}.has_limit()));
}

/// A case with a limit that holds, one that does not, and figures without limits, not-a-number among them.
CaseReport mixed_case() {
  CaseReport report{.name = "column",
                    .title = "Column <collapse>",
                    .source = "Ann & Bob (1952)",
                    .description = "2D",
                    .comparison = "front"};
  report.metrics = {{.name = "front error", .value = 3.5, .unit = "%", .upper = 5.0, .note = "\"late\""},
                    {.name = "peak", .value = 1.5, .unit = "Pa", .lower = 2.0, .upper = 3.0},
                    {.name = "noise", .value = 0.123456789, .unit = "Pa"},
                    {.name = "unknown", .value = kNone}};
  report.tables = {{"Spacings", {"dx [m]", "error <b>"}, {{"0.01", "a & b"}, {"0.02", "'c'"}}}};
  report.run = {.wall_clock = 12.5,
                .particle_steps_per_second = 2.5e6,
                .peak_memory_bytes = 264'000'000,
                .steps = 18'446'744'073'709'551'615ULL,
                .particles = 144'000,
                .penetrations = 7,
                .lost_particles = 3,
                .compression_max = 0.05,
                .compression_p95 = 0.0065,
                .paired_fraction = 0.0125,
                .isolated_fraction = 0.002,
                .energy_gain = 1e-4};
  report.notes = {"The gate <takes> time.", "Second."};
  return report;
}

Report mixed_report() {
  Report report{{"eisph 0.1.0 (abc)", "AMD, 2 cores", "2026-11-24T06:30:00Z", "quick", 2}, {}};
  report.cases = {mixed_case(),
                  {.name = "good", .title = "Good", .metrics = {{.name = "x", .value = 1.0, .upper = 2.0}}},
                  {.name = "lost", .title = "Lost", .failure = "scene.toml: no such file"}};
  return report;
}

TEST(CaseReport, CountsItsLimits) {
  const CaseReport report = mixed_case();
  EXPECT_EQ(report.limits(), 2U);
  EXPECT_EQ(report.limits_held(), 1U);
  EXPECT_FALSE(report.holds());
}

TEST(CaseReport, DoesNotHoldIfItWasNotCarriedOut) {
  const Report report = mixed_report();
  EXPECT_TRUE(report.cases[1].holds());
  EXPECT_FALSE(report.cases[2].holds());
  EXPECT_FALSE(report.holds());
  EXPECT_TRUE((Report{{}, {report.cases[1]}}.holds()));
}

TEST(HtmlEscaped, LeavesNoMarkup) {
  EXPECT_EQ(html_escaped("<a href=\"x\">'&amp;'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;&#39;&lt;/a&gt;");
}

TEST(Base64, AgreesWithTheExamplesOfItsDefinition) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

class ReportFile : public ::testing::Test {
 protected:
  std::string html(const Report& report, const Report* earlier = nullptr) const {
    write_report_html(folder_ / "report.html", report, earlier);
    return text_of(folder_ / "report.html");
  }

  TemporaryFolder folder_;
};

TEST_F(ReportFile, SaysInWordsWhatDoesNotHold) {
  const std::string page = html(mixed_report());
  EXPECT_THAT(page, AllOf(HasSubstr("1 of 3 limits do not hold."),
                          HasSubstr("1 of 3 cases could not be carried out."), HasSubstr("NOT CARRIED OUT"),
                          HasSubstr("scene.toml: no such file")));
  EXPECT_THAT(page, HasSubstr("<b>DOES NOT HOLD:</b> peak 1.5 Pa <span class=\"faint\">(2 to 3)"));
  EXPECT_THAT(page, HasSubstr("front error 3.5 % <span class=\"faint\">(at most 5)"));
  EXPECT_THAT(page, HasSubstr("1 of 2"));
  EXPECT_THAT(page, HasSubstr("not a number"));
  EXPECT_THAT(page, HasSubstr("12.5 s"));
}

TEST_F(ReportFile, SaysThatAllHold) {
  Report report = mixed_report();
  report.cases = {report.cases[1]};
  const std::string page = html(report);
  EXPECT_THAT(page, HasSubstr("All 1 limits hold."));
  EXPECT_THAT(page, Not(HasSubstr("DOES NOT HOLD")));
}

TEST_F(ReportFile, EscapesAllText) {
  Report report = mixed_report();
  const std::string bad = "<script>alert('\"&')</script>";
  CaseReport& one = report.cases[0];
  one.name = one.title = one.source = one.description = one.comparison = one.failure = bad;
  one.metrics[0].name = one.metrics[0].unit = one.metrics[0].note = bad;
  one.tables[0] = {bad, {bad}, {{bad}}};
  one.notes = {bad};
  report.header = {bad, bad, bad, bad, 1};
  put_text(folder_ / "a.png", "png");
  one.figures = {{folder_ / "a.png", bad}};
  Report earlier = report;
  earlier.cases[0].metrics.push_back({.name = bad + "gone", .value = 1.0, .unit = bad});
  const std::string page = html(report, &earlier);
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("alert('")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;&quot;&amp;&#39;)&lt;/script&gt;gone"));
}

TEST_F(ReportFile, HasItsPicturesInside) {
  put_text(folder_ / "a.png", std::string("\x89PNG\r\n", 6));
  Report report = mixed_report();
  report.cases[0].figures = {{folder_ / "a.png", "The front & more"}};
  const std::string page = html(report);
  EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,iVBORw0K\""));
  EXPECT_THAT(page, HasSubstr("<figcaption>The front &amp; more</figcaption>"));
  // Nothing is fetched from elsewhere.
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:|#)")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  report.cases[0].figures = {{folder_ / "none.png", ""}};
  EXPECT_THAT(error_of<InputError>([&] { (void)html(report); }), HasSubstr("none.png"));
}

TEST_F(ReportFile, LinksTheSummaryToTheSections) {
  const std::string page = html(mixed_report());
  for (const char* name : {"case-1", "case-2", "case-3"}) {
    EXPECT_THAT(page, HasSubstr("href=\"#" + std::string(name) + "\""));
    EXPECT_THAT(page, HasSubstr("id=\"" + std::string(name) + "\""));
  }
}

TEST_F(ReportFile, ShowsEarlierValuesAndWhatIsGone) {
  const Report now = mixed_report();
  Report earlier = mixed_report();
  earlier.header.date = "2026-01-01";
  earlier.cases[0].metrics[0].value = 7.0;
  earlier.cases[0].run.wall_clock = 25.0;
  earlier.cases[0].metrics.push_back({.name = "old figure", .value = 4.0, .unit = "mm"});
  const std::string page = html(now, &earlier);
  EXPECT_THAT(page, HasSubstr("2026-01-01"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">7</td><td class=\"number\">0.500</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">25</td><td class=\"number\">0.500</td>"));
  EXPECT_THAT(page,
              AllOf(HasSubstr("Only in the earlier report"), HasSubstr("old figure"), HasSubstr("4 mm")));
}

TEST_F(ReportFile, ComesBackFromJson) {
  Report report = mixed_report();
  std::filesystem::create_directories(folder_ / "figures");
  report.cases[0].figures = {{folder_ / "figures" / "a.png", "The front"}};
  write_report_json(folder_ / "report.json", report);
  EXPECT_THAT(text_of(folder_ / "report.json"), HasSubstr("\"path\": \"figures/a.png\""));

  const Report back = read_report_json(folder_ / "report.json");
  EXPECT_EQ(back.header.version, report.header.version);
  EXPECT_EQ(back.header.host, report.header.host);
  EXPECT_EQ(back.header.date, report.header.date);
  EXPECT_EQ(back.header.mode, "quick");
  EXPECT_EQ(back.header.threads, 2);
  ASSERT_THAT(back.cases, SizeIs(3));
  EXPECT_EQ(back.cases[2].failure, "scene.toml: no such file");
  const CaseReport& one = back.cases[0];
  const CaseReport& original = report.cases[0];
  EXPECT_EQ(one.name, original.name);
  EXPECT_EQ(one.title, original.title);
  EXPECT_EQ(one.source, original.source);
  EXPECT_EQ(one.description, original.description);
  EXPECT_EQ(one.comparison, original.comparison);
  EXPECT_EQ(one.notes, original.notes);
  ASSERT_THAT(one.metrics, SizeIs(4));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(one.metrics[k].name, original.metrics[k].name);
    EXPECT_EQ(one.metrics[k].value, original.metrics[k].value);
    EXPECT_EQ(one.metrics[k].unit, original.metrics[k].unit);
    EXPECT_EQ(one.metrics[k].lower, original.metrics[k].lower);
    EXPECT_EQ(one.metrics[k].upper, original.metrics[k].upper);
    EXPECT_EQ(one.metrics[k].note, original.metrics[k].note);
  }
  EXPECT_THAT(one.metrics[3].value, IsNan());
  ASSERT_THAT(one.figures, SizeIs(1));
  EXPECT_EQ(one.figures[0].path, folder_ / "figures" / "a.png");
  EXPECT_EQ(one.figures[0].caption, "The front");
  ASSERT_THAT(one.tables, SizeIs(1));
  EXPECT_EQ(one.tables[0].caption, "Spacings");
  EXPECT_EQ(one.tables[0].columns, original.tables[0].columns);
  EXPECT_EQ(one.tables[0].rows, original.tables[0].rows);
  EXPECT_EQ(one.run.wall_clock, 12.5);
  EXPECT_EQ(one.run.particle_steps_per_second, 2.5e6);
  EXPECT_EQ(one.run.peak_memory_bytes, 264'000'000U);
  EXPECT_EQ(one.run.steps, 18'446'744'073'709'551'615ULL);
  EXPECT_EQ(one.run.particles, 144'000U);
  EXPECT_EQ(one.run.penetrations, 7U);
  EXPECT_EQ(one.run.lost_particles, 3U);
  EXPECT_EQ(one.run.compression_max, 0.05);
  EXPECT_EQ(one.run.compression_p95, 0.0065);
  EXPECT_EQ(one.run.paired_fraction, 0.0125);
  EXPECT_EQ(one.run.isolated_fraction, 0.002);
  EXPECT_EQ(one.run.energy_gain, 1e-4);
}

TEST_F(ReportFile, ThatIsNoneIsRefused) {
  const auto error = [&](const std::string& text) {
    put_text(folder_ / "report.json", text);
    return error_of<InputError>([&] { (void)read_report_json(folder_ / "report.json"); });
  };
  EXPECT_THAT(error("{"), AllOf(HasSubstr("report.json"), HasSubstr("is no report")));
  EXPECT_THAT(error("[]"), HasSubstr("is no report"));
  EXPECT_THAT(error("{\"format\": \"eisph report 0\"}"), HasSubstr("'eisph report 1'"));
  EXPECT_THAT(error("{\"format\": \"eisph report 1\"}"), HasSubstr("version"));
  EXPECT_THAT(error_of<InputError>([&] { (void)read_report_json(folder_ / "none.json"); }),
              HasSubstr("none.json"));
}

TEST(ReportChanges, ListWhatEitherReportHas) {
  Report now{{}, {{.name = "a", .metrics = {{.name = "x", .value = 3.0}, {.name = "new", .value = 1.0}}}}};
  Report earlier{
      {},
      {{.name = "a", .metrics = {{.name = "old", .value = 5.0, .unit = "m"}, {.name = "x", .value = 2.0}}},
       {.name = "b", .metrics = {{.name = "x", .value = 9.0}}}}};
  now.cases[0].run = {.wall_clock = 10.0, .steps = 1};
  const std::vector<MetricChange> changes = report_changes(now, earlier);
  const auto find = [&](const std::string& name, const std::string& metric) {
    for (const MetricChange& change : changes) {
      if (change.case_name == name && change.metric == metric) return change;
    }
    return MetricChange{};
  };
  EXPECT_EQ(changes.front().metric, "x");
  EXPECT_EQ(changes.front().before, 2.0);
  EXPECT_EQ(changes.front().now, 3.0);
  EXPECT_DOUBLE_EQ(changes.front().ratio(), 1.5);
  EXPECT_FALSE(find("a", "new").before.has_value());
  EXPECT_THAT(find("a", "new").ratio(), IsNan());
  EXPECT_FALSE(find("a", "old").now.has_value());
  EXPECT_EQ(find("a", "old").before, 5.0);
  EXPECT_EQ(find("a", "old").unit, "m");
  EXPECT_EQ(find("b", "x").before, 9.0);
  EXPECT_EQ(find("a", "wall clock").now, 10.0);
  EXPECT_EQ(changes.back().case_name, "b");
}

}  // namespace
}  // namespace eisph

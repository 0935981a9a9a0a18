#include "app/validate/cases.hpp"

#include "core/error.hpp"

#include <exception>

namespace eisph {

const std::vector<ValidationCase>& validation_cases() {
  static const std::vector<ValidationCase> cases = {
      {"still_water", "Still water", true, validate_still_water},
      {"solids", "Solids in water", true, validate_solids},
      {"sloshing", "Standing wave", true, validate_sloshing},
      {"shao_lo_2d", "Column of Shao & Lo in two dimensions", true, validate_shao_lo_2d},
      {"shao_lo_3d", "Column of Shao & Lo in three dimensions", true, validate_shao_lo_3d},
      {"martin_moyce_n1", "Square column of Martin & Moyce", true, validate_martin_moyce_n1},
      {"martin_moyce_n2", "Tall column of Martin & Moyce", true, validate_martin_moyce_n2},
      {"ritter", "Dam break on a dry bed, the thesis's box", true, validate_ritter_box},
      {"ritter_long", "Dam break on a dry bed, long reservoir", true, validate_ritter_long},
      {"stoker", "Dam break on a wet bed", true, validate_stoker},
      {"buchner", "Dam break against a wall (Buchner)", true, validate_buchner},
      {"janosi", "Dam break on a wet bed behind a gate (Janosi et al.)", true, validate_janosi},
      {"lobovsky", "Dam break against a wall, repeated (Lobovsky et al.)", true, validate_lobovsky},
      {"block_impact", "Dam break against a block (interFoam)", true, validate_block_impact},
      {"aureli_test4", "Dam break around an obstacle (Aureli et al., test 4)", true, validate_aureli_test4},
      {"aureli_half", "The same in half of the tank", false, validate_aureli_half},
      {"aureli_test1", "Dam break in a flat tank (Aureli et al., test 1)", false, validate_aureli_test1},
      {"aureli_test2", "The same on a wet floor (Aureli et al., test 2)", false, validate_aureli_test2},
      {"aureli_test3", "The same over a block under water (Aureli et al., test 3)", false,
       validate_aureli_test3},
  };
  return cases;
}

CaseReport carry_out(const ValidationCase& validation_case, Validator& validator) {
  CaseReport report;
  report.name = validation_case.name;
  report.title = validation_case.title;
  validator.begin_case(validation_case.name);
  try {
    validation_case.carry_out(validator, report);
  } catch (const BlowUpError& error) {
    report.failure = error.what();
  } catch (const InputError& error) {
    report.failure = error.what();
  }
  report.run = validator.figures();
  add_at_most(report, "penetrations", static_cast<double>(report.run.penetrations), 0.0, "particles",
              "put back inside a wall or a solid, all runs");
  add_at_most(report, "lost particles", static_cast<double>(report.run.lost_particles), 0.0, "particles");
  return report;
}

void add_at_most(CaseReport& report, const std::string& name, double value, double limit,
                 const std::string& unit, const std::string& note) {
  report.metrics.push_back(
      {.name = name, .value = value, .unit = unit, .lower = {}, .upper = limit, .note = note});
}

void add_within(CaseReport& report, const std::string& name, double value, double lower, double upper,
                const std::string& unit, const std::string& note) {
  report.metrics.push_back(
      {.name = name, .value = value, .unit = unit, .lower = lower, .upper = upper, .note = note});
}

void add_information(CaseReport& report, const std::string& name, double value, const std::string& unit,
                     const std::string& note) {
  report.metrics.push_back(
      {.name = name, .value = value, .unit = unit, .lower = {}, .upper = {}, .note = note});
}

void add_pairs(CaseReport& report, const ValidationRun& run, const std::string& suffix) {
  add_at_most(report, "particles within 0.6 dx" + suffix, 100.0 * run.summary.paired_fraction_max, 2.0, "%",
              "of the nearest other one, largest over the run");
}

}  // namespace eisph

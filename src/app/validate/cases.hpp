#pragma once

#include "app/validate/validator.hpp"
#include "compare/curve_difference.hpp"
#include "compare/report.hpp"

#include <functional>
#include <string>
#include <vector>

namespace eisph {

/// One case: makes its runs, compares, draws its figures.
struct ValidationCase {
  std::string name;
  std::string title;
  bool quick = true;  ///< part of a quick validation
  std::function<void(Validator&, CaseReport&)> carry_out;
};

/// All cases in the order of the report.
[[nodiscard]] const std::vector<ValidationCase>& validation_cases();

/// Carries out one case. A blow-up and an unusable table become CaseReport::failure; the figures of the runs
/// and limits on penetrations and lost particles are added. Throws ValidationInterrupted.
[[nodiscard]] CaseReport carry_out(const ValidationCase& validation_case, Validator& validator);

// The cases, by the file that holds them.
void validate_still_water(Validator& validator, CaseReport& report);
void validate_solids(Validator& validator, CaseReport& report);
void validate_sloshing(Validator& validator, CaseReport& report);
void validate_shao_lo_2d(Validator& validator, CaseReport& report);
void validate_shao_lo_3d(Validator& validator, CaseReport& report);
void validate_martin_moyce_n1(Validator& validator, CaseReport& report);
void validate_martin_moyce_n2(Validator& validator, CaseReport& report);
void validate_ritter_box(Validator& validator, CaseReport& report);
void validate_ritter_long(Validator& validator, CaseReport& report);
void validate_stoker(Validator& validator, CaseReport& report);
void validate_buchner(Validator& validator, CaseReport& report);
void validate_janosi(Validator& validator, CaseReport& report);
void validate_lobovsky(Validator& validator, CaseReport& report);
void validate_block_impact(Validator& validator, CaseReport& report);
void validate_aureli_test4(Validator& validator, CaseReport& report);
void validate_aureli_half(Validator& validator, CaseReport& report);
void validate_aureli_test1(Validator& validator, CaseReport& report);
void validate_aureli_test2(Validator& validator, CaseReport& report);
void validate_aureli_test3(Validator& validator, CaseReport& report);

// Metrics: with an upper limit, within limits, or for information.
void add_at_most(CaseReport& report, const std::string& name, double value, double limit,
                 const std::string& unit = "-", const std::string& note = "");
void add_within(CaseReport& report, const std::string& name, double value, double lower, double upper,
                const std::string& unit = "-", const std::string& note = "");
void add_information(CaseReport& report, const std::string& name, double value, const std::string& unit = "-",
                     const std::string& note = "");
/// Limit on the particles of a run within 0.6 spacings of another; `suffix` tells runs of a case apart.
void add_pairs(CaseReport& report, const ValidationRun& run, const std::string& suffix = "");

}  // namespace eisph

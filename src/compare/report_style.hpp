#pragma once

namespace eisph {

/// Style sheet of the report: dark text on white, also on paper.
inline constexpr const char* kReportStyle = R"css(
body { max-width: 62rem; margin: 2rem auto; padding: 0 1.2rem; color: #1c1c1e; background: #fff;
  font: 15px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; }
h2 { font-size: 1.3rem; margin: 3rem 0 .5rem; padding-top: .8rem; border-top: 2px solid #c8c8cc; }
h3 { font-size: 1.02rem; margin: 1.5rem 0 .4rem; }
p { margin: .4rem 0; }
a { color: #00558a; }
.faint { color: #55555a; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: .5rem 0; font-size: .92rem; }
th, td { padding: .28rem .7rem; border-bottom: 1px solid #dcdce0; text-align: left; vertical-align: top; }
th { border-bottom: 2px solid #a8a8ac; font-weight: 600; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.number { white-space: nowrap; }
td.wide { min-width: 22rem; }
.holds { color: #00633f; font-weight: 600; white-space: nowrap; }
.fails { color: #a31515; font-weight: 700; white-space: nowrap; }
tr.fails-row td { background: #fdeceb; }
.verdict { padding: .6rem .9rem; margin: 1rem 0; border-left: 5px solid #00835a; background: #eef7f3; }
.verdict.bad { border-left-color: #c02020; background: #fdeceb; }
figure { margin: 1.2rem 0; break-inside: avoid; }
figure img { max-width: 100%; height: auto; border: 1px solid #e4e4e8; }
figcaption { font-size: .92rem; color: #333338; }
@media print { body { max-width: none; margin: 0; font-size: 11px; } tr { break-inside: avoid; } }
)css";

}  // namespace eisph

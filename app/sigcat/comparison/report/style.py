"""The style of the self-contained page; within the service the pages' own style has the same classes."""

STYLE = """\
:root {
  color-scheme: light dark; --ground: light-dark(#fbfbfa, #15181b); --raised: light-dark(#ffffff, #1b1f23);
  --sunken: light-dark(#f2f3f1, #101315); --line: light-dark(#dfe2df, #2b3136); --line-strong: light-dark(#8b938f, #6b757c);
  --text: light-dark(#1c2321, #e3e7e6); --muted: light-dark(#5a6562, #9aa5a6); --accent: light-dark(#0b6b62, #5cc8ba);
  --error: light-dark(#b3261e, #ff8d83); --accent-ground: light-dark(#dff0ed, #163634); --error-ground: light-dark(#fdeceb, #3a1d1b); --series-0: light-dark(#9fb8d6, #49607c); --series-1: light-dark(#0b6b62, #5cc8ba);
  --series-2: light-dark(#96500a, #eeb067); --series-3: light-dark(#6f3fa6, #c3a0ee);
  --series-4: light-dark(#b3261e, #ff8d83); --series-5: light-dark(#2f6f9f, #7fb8e6);
  --series-6: light-dark(#a1286a, #f08cc0);
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--text); font: 14px/1.5 system-ui, "Liberation Sans", sans-serif; font-variant-numeric: tabular-nums; }
main { max-width: 1180px; margin: 0 auto; padding: 24px 24px 64px; }
h1 { font-size: 24px; line-height: 1.25; margin: 0 0 8px; }
h2 { font-size: 16px; margin: 36px 0 8px; }
a { color: var(--accent); }
.muted { color: var(--muted); } td.muted { overflow-wrap: normal; } .good { color: var(--accent); font-weight: 600; } .bad { color: var(--error); font-weight: 600; }
.remark { max-width: 80ch; margin: 4px 0; } figure { margin: 14px 0; } figcaption { color: var(--muted); font-size: 13px; max-width: 80ch; }
.chips { list-style: none; display: flex; flex-wrap: wrap; gap: 4px 14px; padding: 0; }
.scroll { overflow-x: auto; margin-top: 10px; } table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 5px 12px 5px 0; border-bottom: 1px solid var(--line); font-weight: 400; overflow-wrap: anywhere; min-width: 4em; }
thead th { color: var(--muted); font-size: 12px; font-weight: 650; } tbody th { min-width: 9em; }
h3 { font-size: 14px; margin: 16px 0 0; }
pre { margin: 8px 0 0; padding: 10px 14px; background: var(--sunken); border: 1px solid var(--line); border-radius: 6px; overflow-x: auto; font-size: 12.5px; }
.summary td { padding-left: 10px; border-left: 1px solid var(--line); } .summary .good { background: var(--accent-ground); } .summary .bad { background: var(--error-ground); }
details { margin-top: 8px; } summary { cursor: pointer; color: var(--muted); }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
@media (max-width: 640px) {
  thead { position: absolute; clip-path: inset(50%); } .stacked tr, .stacked th, .stacked td { display: block; }
  .stacked tr { padding: 8px 0; border-bottom: 1px solid var(--line); } .stacked th, .stacked td { border: 0; padding: 1px 0; }
  .stacked td[data-label]::before { content: attr(data-label) ": "; color: var(--muted); font-weight: 400; } .stacked td:empty { display: none; }
}
.diagram { display: block; min-width: 720px; max-width: 100%; height: auto; font: 13px system-ui, sans-serif; }
.diagram text { fill: var(--text); } .diagram .minor { fill: var(--muted); font-size: 12px; } .diagram .strong { font-weight: 600; }
.comparison .middle { text-anchor: middle; } .comparison .end { text-anchor: end; } .comparison .mark { stroke: var(--line); }
.comparison .frame { fill: none; stroke: var(--line-strong); } .comparison .trace { fill: none; stroke-width: 1.2; stroke-linejoin: round; }
.comparison .series-0 { stroke: var(--series-0); fill: var(--series-0); } .comparison .series-1 { stroke: var(--series-1); fill: var(--series-1); }
.comparison .series-2 { stroke: var(--series-2); fill: var(--series-2); } .comparison .series-3 { stroke: var(--series-3); fill: var(--series-3); }
.comparison .series-4 { stroke: var(--series-4); fill: var(--series-4); } .comparison .series-5 { stroke: var(--series-5); fill: var(--series-5); }
.comparison .series-6 { stroke: var(--series-6); fill: var(--series-6); }
.comparison .trace { fill: none; } .comparison .trace.series-0 { stroke-width: 7; } .comparison .trace.series-1 { stroke-width: 3.4; }
.comparison .trace.series-2 { stroke-width: 1.8; stroke-dasharray: 7 5; } .comparison .trace.series-3 { stroke-width: 1.2; stroke-dasharray: 2 6; }
.comparison .trace.series-4 { stroke-width: 1; stroke-dasharray: 1 9; } .comparison .trace.series-5 { stroke-width: 1; stroke-dasharray: 9 3 1 3; }
.comparison .trace.series-6 { stroke-width: 1; stroke-dasharray: 3 7; }
.comparison .hill { fill-opacity: 0.35; } .comparison .median { stroke: var(--text); stroke-width: 2; } .comparison .p99 { stroke: var(--text); stroke-dasharray: 3 3; }
.comparison .paper { stroke: var(--error); stroke-dasharray: 6 4; }
"""

/** Makespans of one policy over the number of shards. */
export interface Line {
  readonly name: string;
  readonly dashes: string;
  /** Hours in the mean over seeds. */
  readonly points: readonly { readonly shards: number; readonly hours: number }[];
}

/** One half of the picture. */
export interface Panel {
  readonly title: string;
  readonly lines: readonly Line[];
  /** All work over all slots, h. */
  readonly ideal: number;
}

const WIDTH = 960;
const HEIGHT = 430;
const TOP = 100;
const BOTTOM = 350;
const PANEL = { width: 370, gap: 90, left: 70 };
const LEGEND = { y: 404, step: 200 };

const STYLE = `svg{--ground:#fff;--ink:#1d2733;--faint:#8b97a6;--bar:#2f6f9f}
@media (prefers-color-scheme:dark){svg{--ground:#10161d;--ink:#e4eaf1;--faint:#7d8a99;--bar:#6fb3e0}}
text{font:13px system-ui,sans-serif;fill:var(--ink)}.faint{fill:var(--faint)}.title{font-weight:600;font-size:16px}
.axis{stroke:var(--faint);fill:none}.line{stroke:var(--bar);fill:none;stroke-width:2}`;

const range = (from: number, to: number): number[] => Array.from({ length: to - from + 1 }, (_, i) => from + i);
/** A power of ten, without the errors of `10 ** n`. */
const tenTo = (power: number): number => Number(`1e${power}`);

/** Draws how long a plan takes over its number of shards. Both scales are logarithmic. */
export function drawFleet(panels: readonly Panel[], machines: string): string {
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="Hours over the number of shards, with and without failures">
<style>${STYLE}</style><rect width="${WIDTH}" height="${HEIGHT}" rx="10" style="fill:var(--ground)"/>
<text class="title" x="24" y="34">A simulated fleet: hours over the number of shards</text>
<text class="faint" x="24" y="56">${machines}; both scales are logarithmic</text>
${panels.map((panel, i) => drawPanel(panel, PANEL.left + i * (PANEL.width + PANEL.gap))).join('\n')}
${drawLegend(panels[0].lines)}
</svg>
`;
}

/** Names the lines, which are the same in all panels. */
function drawLegend(lines: readonly Line[]): string {
  const keys = [
    ...lines.map(({ name, dashes }) => ({ name, look: `class="line" stroke-dasharray="${dashes}"` })),
    { name: 'ideal: all work over all cores', look: 'class="axis"' },
  ];
  return keys
    .map(({ name, look }, i) => {
      const x = PANEL.left + i * LEGEND.step;
      return `<path ${look} d="M${x} ${LEGEND.y}h36"/><text x="${x + 44}" y="${LEGEND.y + 4}">${name}</text>`;
    })
    .join('\n');
}

function drawPanel({ title, lines, ideal }: Panel, left: number): string {
  const right = left + PANEL.width;
  const all = lines.flatMap(({ points }) => points);
  const [first, last] = [Math.min, Math.max].map((pick) => Math.log10(pick(...all.map(({ shards }) => shards))));
  const low = Math.floor(Math.log10(Math.min(ideal, ...all.map(({ hours }) => hours))));
  const high = Math.ceil(Math.log10(Math.max(...all.map(({ hours }) => hours))));
  const x = (shards: number): number => left + ((Math.log10(shards) - first) / (last - first)) * PANEL.width;
  const y = (hours: number): number => BOTTOM - ((Math.log10(hours) - low) / (high - low)) * (BOTTOM - TOP);
  const hours = range(low, high).map((power) => {
    const at = y(tenTo(power)).toFixed(1);
    return `<path class="axis" d="M${left} ${at}H${right}" opacity="0.4"/><text class="faint" x="${left - 8}" y="${(Number(at) + 4).toFixed(1)}" text-anchor="end">${tenTo(power)}</text>`;
  });
  const shards = range(Math.ceil(first), Math.floor(last)).map(
    (power) =>
      `<text class="faint" x="${x(tenTo(power)).toFixed(1)}" y="${BOTTOM + 20}" text-anchor="middle">${tenTo(power).toLocaleString('en-US')}</text>`,
  );
  const drawn = lines.map(({ dashes, points }) => {
    const places = points.map((point) => `${x(point.shards).toFixed(1)},${y(point.hours).toFixed(1)}`).join(' ');
    return `<polyline class="line" points="${places}" stroke-dasharray="${dashes}"/>`;
  });
  return [
    `<text x="${left}" y="${TOP - 16}">${title}</text>`,
    ...hours,
    ...shards,
    `<text class="faint" x="${right}" y="${BOTTOM + 40}" text-anchor="end">shards</text>`,
    `<path class="axis" d="M${left} ${y(ideal).toFixed(1)}H${right}"/>`,
    ...drawn,
  ].join('\n');
}

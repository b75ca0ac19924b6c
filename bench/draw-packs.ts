/** Levels a second. */
export interface Rates {
  /** Checked, for each second of processor time. */
  readonly perCore: number;
  /** Checked with two workers. */
  readonly twoWorkers: number;
  /** Read and left to other shards. */
  readonly scanned: number;
  readonly planned: number;
  readonly merged: number;
}

/** The most memory that each command needs for a set, MB. */
export interface Memory {
  readonly size: number;
  readonly check: number;
  readonly plan: number;
  readonly shard: number;
  readonly merge: number;
}

const WIDTH = 960;
const HEIGHT = 400;
const PLOT = { left: 70, top: 90, right: 450, bottom: 330 };
const MOST_MEMORY = 300;
const BARS = { left: 660, right: 900, top: 100, step: 46 };
const COMMANDS = ['check', 'plan', 'shard', 'merge'] as const;
const DASHES = { check: '', plan: '6 4', shard: '2 3', merge: '9 3 2 3' } as const;

const STYLE = `svg{--ground:#fff;--ink:#1d2733;--faint:#8b97a6;--bar:#2f6f9f}
@media (prefers-color-scheme:dark){svg{--ground:#10161d;--ink:#e4eaf1;--faint:#7d8a99;--bar:#6fb3e0}}
text{font:13px system-ui,sans-serif;fill:var(--ink)}.faint{fill:var(--faint)}.title{font-weight:600;font-size:16px}
.axis{stroke:var(--faint);fill:none}.line{stroke:var(--bar);fill:none;stroke-width:2}.bar{fill:var(--bar)}`;

const rounded = (rate: number): string => Number(rate.toPrecision(2)).toLocaleString('en-US');

/** Draws how much memory sets of different sizes need, and how many levels a second each command does. */
export function drawPacks(memory: readonly Memory[], rates: Rates): string {
  const [first, last] = [memory[0].size, memory[memory.length - 1].size].map(Math.log10);
  const x = (size: number): number => PLOT.left + ((Math.log10(size) - first) / (last - first)) * (PLOT.right - PLOT.left);
  const y = (mb: number): number => PLOT.bottom - (mb / MOST_MEMORY) * (PLOT.bottom - PLOT.top);
  const ends = COMMANDS.map((name) => ({ name, at: y(memory[memory.length - 1][name]) })).sort((a, b) => a.at - b.at);
  for (let i = 1; i < ends.length; i++) ends[i].at = Math.max(ends[i].at, ends[i - 1].at + 16);
  const lines = COMMANDS.map((name) => {
    const points = memory.map((row) => `${x(row.size).toFixed(1)},${y(row[name]).toFixed(1)}`).join(' ');
    return `<polyline class="line" points="${points}" stroke-dasharray="${DASHES[name]}"/>`;
  });
  const labels = ends.map(({ name, at }) => `<text x="${PLOT.right + 8}" y="${(at + 4).toFixed(1)}">${name}</text>`);
  const ticks = [0, 100, 200, 300].map(
    (mb) =>
      `<path class="axis" d="M${PLOT.left} ${y(mb)}H${PLOT.right}" opacity="0.4"/><text class="faint" x="${PLOT.left - 8}" y="${y(mb) + 4}" text-anchor="end">${mb}</text>`,
  );
  const sizes = memory.map(
    ({ size }) =>
      `<text class="faint" x="${x(size).toFixed(1)}" y="${PLOT.bottom + 20}" text-anchor="middle">${size.toLocaleString('en-US')}</text>`,
  );
  const bars = [
    ['check, a core', rates.perCore],
    ['check, two workers', rates.twoWorkers],
    ['plan', rates.planned],
    ['skip in a shard', rates.scanned],
    ['merge', rates.merged],
  ] as const;
  const most = Math.log10(Math.max(...bars.map(([, rate]) => rate)));
  const drawn = bars.map(([name, rate], i) => {
    const top = BARS.top + i * BARS.step;
    // from 100 a second on
    const width = ((Math.log10(rate) - 2) / (most - 2)) * (BARS.right - BARS.left);
    return `<text x="${BARS.left - 10}" y="${top + 15}" text-anchor="end">${name}</text><rect class="bar" x="${BARS.left}" y="${top}" width="${width.toFixed(1)}" height="20"/><text x="${BARS.left}" y="${top + 36}" class="faint">${rounded(rate)}</text>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="Memory over the number of levels, and levels a second">
<style>${STYLE}</style><rect width="${WIDTH}" height="${HEIGHT}" rx="10" style="fill:var(--ground)"/>
<text class="title" x="24" y="34">Packs of levels: memory does not grow with their number</text>
<text class="faint" x="24" y="66">most memory of a process, MB, over the number of levels</text><text class="faint" x="${BARS.left - 140}" y="66">levels a second, on a logarithmic scale</text>
${[...ticks, ...sizes, ...lines, ...labels, ...drawn].join('\n')}
</svg>
`;
}

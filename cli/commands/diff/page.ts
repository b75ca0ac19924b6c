import { createHash } from 'node:crypto';
import { compareHolds } from '../../../check/runs/index.ts';
import { outcomeInWords } from '../../../check/words/index.ts';
import { boxOf, type Run, STATE_SIZE, TICK } from '../../../engine/index.ts';
import { type Comparison, pathOf, renderComparison } from '../../../picture/comparison/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { type Hold, type Level, rulesOf, type Verdict } from '../../../schema/index.ts';
import type { Diff, DiffedLevel, DiffStatus, PlayedVersion, PlayedVersions } from '../../diff/index.ts';
import { visibleLine } from '../../terminal/index.ts';
import { PLAYER, STYLE } from './page-parts.ts';
import { countsInWords, linesOf, pathInWords, rulesInWords, termsChangesInWords, turnsInWords } from './text.ts';

/** Pictures take most of the room: further levels have words only. */
const MOST_PICTURES = 60;

/** A level that looks as before needs no picture. */
const HAS_PICTURES: ReadonlySet<DiffStatus> = new Set(['added', 'removed', 'changed', 'rules']);

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

/** Any text, for the inside of an element or of a quoted attribute. */
const html = (text: string): string => visibleLine(text).replace(/[&<>"']/g, (c) => ENTITIES[c]);

const sha = (text: string): string => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** The policy that the page sets for itself: its own script and style, pictures that it contains, and nothing else. */
const POLICY = `default-src 'none'; img-src data:; style-src ${sha(STYLE)}; script-src ${sha(PLAYER)}; base-uri 'none'; form-action 'none'`;

/** A run as the player needs it. */
interface PlayerRun {
  readonly when: 'before' | 'after';
  /** x, y and angle in degrees for each tick, in units of the picture. */
  readonly at: readonly number[];
}

interface PlayerLevel {
  readonly runs: readonly PlayerRun[];
  readonly ticks: number;
}

/**
 * The diff as one page that needs no network: pictures, both runs on one stage, their timelines, and the changes in words.
 * @param play reads both versions of the level with this index and plays their runs
 */
export function diffPage(diff: Diff, play: (index: number) => PlayedVersions): string {
  const { levels, comparison, same } = diff;
  const title = `${comparison.before.label} -> ${comparison.after.label}`;
  const players: Record<string, PlayerLevel> = {};
  const sections = levels.map((level, i) => {
    const versions = i < MOST_PICTURES && HAS_PICTURES.has(level.status) ? play(i) : null;
    return sectionOf(level, i, versions, players);
  });
  const rules = rulesInWords(diff);
  const terms = termsChangesInWords(diff);
  const said = [
    `<p>${levels.length === 0 ? 'No level changed.' : html(countsInWords(levels))}</p>`,
    ...turnsInWords(levels).map((turn) => `<p class="${turn.includes('no longer') ? 'bad' : 'good'}">${html(turn)}</p>`),
    ...(rules.length > 0
      ? [`<p>The rules in gq.config.json changed, which changes how every level plays: ${html(rules.join(', '))}</p>`]
      : []),
    ...(terms.length > 0
      ? [`<p>The terms in gq.config.json changed, under which every level is judged: ${html(terms.join(', '))}</p>`]
      : []),
    ...(same > 0 ? [`<p>${same} more with the same file play as before.</p>`] : []),
    ...(levels.length > MOST_PICTURES ? [`<p>The first ${MOST_PICTURES} levels have pictures.</p>`] : []),
  ];
  const contents =
    levels.length < 2
      ? ''
      : `<nav aria-label="Levels"><ul>${levels.map((level, i) => `<li><a href="#level-${i}">${html(pathInWords(level))}</a></li>`).join('')}</ul></nav>`;
  // in JSON every < can be written so, and then no text ends the element
  const data = JSON.stringify(players).replaceAll('<', '\\u003c');
  return (
    `<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${html(POLICY)}">` +
    `<meta name="viewport" content="width=device-width, initial-scale=1"><title>${html(title)}</title><style>${STYLE}</style></head>` +
    `<body><header><h1>${html(title)}</h1>${said.join('')}${contents}</header><main>${sections.join('')}</main>` +
    `<script type="application/json" id="runs">${data}</script><script>${PLAYER}</script></body></html>\n`
  );
}

const tone = (verdict: Verdict | undefined): string => (verdict === 'completable' ? 'good' : 'bad');

const badge = (words: string, className: string): string => `<span class="badge ${className}">${html(words)}</span>`;

function sectionOf(
  level: DiffedLevel,
  index: number,
  versions: PlayedVersions | null,
  players: Record<string, PlayerLevel>,
): string {
  const { before, after, status, effects } = level;
  const badges = [
    badge(status, 'plain'),
    ...(before === null || before.verdict === after?.verdict ? [] : [badge(before.verdict, tone(before.verdict))]),
    ...(before === null || after === null || before.verdict === after.verdict ? [] : ['<span aria-label="then">→</span>']),
    ...(after === null ? [] : [badge(after.verdict, tone(after.verdict))]),
  ].join(' ');
  const changes = linesOf(level).map((line) => `<li>${html(line)}</li>`);
  const turned = before !== null && after !== null && before.verdict !== after.verdict ? ` ${tone(after.verdict)}` : '';
  const words =
    (changes.length > 0 ? `<h3>What changed</h3><ul class="words">${changes.join('')}</ul>` : '') +
    (effects.length > 0
      ? `<h3>What follows</h3><ul class="effects${turned}">${effects.map((line) => `<li>${html(line)}</li>`).join('')}</ul>`
      : status === 'layout' || status === 'renamed'
        ? ''
        : '<p class="plain">The level plays as before.</p>');
  const pictures = versions === null ? null : picturesOf(versions, String(index), players);
  const name = (after ?? before)?.name ?? '';
  return (
    `<section id="level-${index}" data-level="${index}" aria-labelledby="name-${index}"><h2 id="name-${index}">${html(pathInWords(level))}</h2>` +
    `<p class="name">${html(name)}</p><p>${badges}</p>` +
    (pictures === null ? words : `<div class="columns"><div>${pictures.stage}</div><div>${words}</div></div>${pictures.pair}`) +
    '</section>'
  );
}

/** A picture that follows the reader's system. */
function image(draw: (theme: 'dark' | 'light') => string, about: string): string {
  const uri = (theme: 'dark' | 'light'): string => `data:image/svg+xml;base64,${Buffer.from(draw(theme)).toString('base64')}`;
  return (
    `<picture><source media="(prefers-color-scheme: dark)" srcset="${uri('dark')}">` +
    `<img src="${uri('light')}" alt="${html(about)}"></picture>`
  );
}

function picturesOf(
  { before, after, marks }: PlayedVersions,
  key: string,
  players: Record<string, PlayerLevel>,
): { readonly stage: string; readonly pair: string } | null {
  const only = after ?? before;
  if (only === null) return null;
  const [old, now] = [(before ?? only).level, (after ?? only).level];
  const sides = [
    { when: 'before' as const, version: before },
    { when: 'after' as const, version: after },
  ].flatMap(({ when, version }) => (version?.run == null ? [] : [{ when, version, run: version.run }]));
  // runs are drawn over the picture, so it only has to make room for them
  const drawn = (theme: 'dark' | 'light'): Comparison => renderComparison(old, now, marks, { theme, words: false, room: sides });
  const { view } = drawn('light');
  const played = sides.map(({ when, run }): PlayerRun => ({ when, at: positionsOf(run, view) }));
  const ticks = Math.max(1, ...played.map(({ at }) => at.length / 3 - 1));
  players[key] = { runs: played, ticks };
  const overlay = sides.map(({ when, run, version }) => ghostOf(when, run, version.level, view)).join('');
  const stage =
    `<div class="stage">${image((theme) => drawn(theme).svg, 'What changed, and the paths of both runs')}` +
    `<svg viewBox="0 0 ${view.width} ${view.height}" aria-hidden="true">${overlay}</svg></div>` +
    (sides.length === 0 ? '' : controlsOf(sides, ticks, key));
  const alone = (version: PlayedVersion | null, when: string): string => {
    if (version === null) return '';
    const draw = (theme: 'dark' | 'light') =>
      renderSvg(version.level, { theme, width: 760, ...(version.run !== null && { run: version.run }) });
    return `<figure><h3>${when}</h3>${image(draw, `${when}: the level and its run`)}</figure>`;
  };
  return { stage, pair: `<div class="pair">${alone(before, 'Before')}${alone(after, 'After')}</div>` };
}

const tenth = (value: number): number => Math.round(10 * value) / 10 + 0;

function positionsOf(run: Run, view: Comparison['view']): number[] {
  const state = new Float64Array(STATE_SIZE);
  const at: number[] = [];
  const end = run.trajectory.duration;
  const look = (time: number): void => {
    run.trajectory.at(time, state);
    const [x, y, , , cos, sin] = state;
    at.push(tenth(view.x + view.scale * x), tenth(view.y + view.scale * y), tenth((Math.atan2(sin, cos) * 180) / Math.PI));
  };
  for (let tick = 0; tick * TICK < end; tick++) look(tick * TICK);
  look(end);
  return at;
}

/** The path of a run, and the box that moves along it. */
function ghostOf(when: 'before' | 'after', run: Run, level: Level, view: Comparison['view']): string {
  const { held, free } = pathOf(run, view);
  const { halfWidth, halfHeight } = boxOf(rulesOf(level));
  const [w, h] = [Math.max(5, halfWidth * view.scale), Math.max(8, halfHeight * view.scale)].map(tenth);
  return (
    `<g class="${when}"><path class="way free" d="${free}"/><path class="way held" d="${held}"/></g>` +
    `<g class="ghost ${when}"><rect x="${-w}" y="${-h}" width="${2 * w}" height="${2 * h}" rx="3"/><text y="5">${when === 'before' ? 1 : 2}</text></g>`
  );
}

function controlsOf(
  sides: readonly { readonly when: 'before' | 'after'; readonly version: PlayedVersion; readonly run: Run }[],
  ticks: number,
  key: string,
): string {
  const ends = sides.map(
    ({ when, version, run }) =>
      `<span><span class="key ${when}">${when === 'before' ? '1 before' : '2 after'}</span> ${html(`${version.judged?.name ?? ''}: ${outcomeInWords(run, version.level.range)}`)}</span>`,
  );
  const holds = (when: 'before' | 'after'): readonly Hold[] =>
    sides.find((side) => side.when === when)?.version.judged?.holds ?? [];
  const isBoth = sides.length === 2;
  const { moved } = isBoth ? compareHolds(holds('before'), holds('after')) : { moved: [] };
  const at = (tick: number): number => tenth((1000 * Math.min(tick, ticks)) / ticks);
  const lane = (when: 'before' | 'after', y: number): string => {
    const end = sides.find((side) => side.when === when)?.run.tick ?? 0;
    const blocks = holds(when)
      .filter(([press]) => press < ticks)
      .map(
        ([press, release]) =>
          `<rect class="${when}" x="${at(press)}" y="${y}" width="${Math.max(1, tenth(at(release) - at(press)))}" height="16"/>`,
      );
    return `<rect class="lane" x="0" y="${y}" width="${at(end)}" height="16"/>${blocks.join('')}`;
  };
  const edges = moved.map(({ before, after }) => `<line class="edge" x1="${at(before)}" y1="22" x2="${at(after)}" y2="38"/>`);
  const said = moved
    .slice(0, 12)
    .map(({ edge, hold, before, after }) => `${edge} ${hold + 1}: tick ${before} → ${after}`)
    .join(', ');
  return (
    `<div class="controls"><button type="button">Play</button>` +
    `<input type="range" min="0" max="${ticks}" value="0" step="1" aria-label="Time, in ticks" id="time-${key}"><output for="time-${key}">0.00 s</output></div>` +
    `<svg class="lanes" viewBox="0 0 1000 62" preserveAspectRatio="none" role="img" aria-label="Holds of both runs">` +
    `${lane('before', 6)}${lane('after', 38)}${edges.join('')}<line class="head" x1="0" x2="0" y1="0" y2="62"/></svg>` +
    `<p class="ends">${ends.join('')}</p>${said === '' ? '' : `<p class="edges">Moved: ${html(said)}${moved.length > 12 ? ', …' : ''}</p>`}`
  );
}

/** How a picture is drawn. */
export interface PictureOptions {
  readonly width: number;
  readonly theme: 'dark' | 'light';
}

/** The run of a version with the label of its timeline. */
export const labelled = (when: string, { level, run, judged }: PlayedVersion) =>
  run === null || judged === null ? [] : [{ run, label: `${when}: ${judged.name}, ${outcomeInWords(run, level.range)}` }];

/** Both versions of a level in one picture; a level that is there on one side only is drawn alone. null: there is none. */
export function diffSvg(diffed: DiffedLevel, { before, after, marks }: PlayedVersions, options: PictureOptions): string | null {
  const only = before ?? after;
  if (only === null) return null;
  const name = (after ?? only).level.name;
  if (before === null || after === null) {
    const note = diffed.before === null ? 'added' : diffed.after === null ? 'removed' : linesOf(diffed).join('; ');
    return renderSvg(only.level, { ...(only.run !== null && { run: only.run }), ...options, note });
  }
  const note = [...linesOf(diffed), ...diffed.effects].join('; ');
  const runs = [...labelled('before', before), ...labelled('after', after)];
  return renderComparison(before.level, after.level, marks, { ...options, runs, title: name, note }).svg;
}

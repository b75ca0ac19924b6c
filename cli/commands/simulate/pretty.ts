import { bodyInWords, countMinerals, holdsInWords, outcomeInWords } from '../../../check/words/index.ts';
import { effectEventInWords, type Run, type RunEvent } from '../../../engine/index.ts';
import { type Level, objectName, type RunReport } from '../../../schema/index.ts';
import { type Colors, visibleLine } from '../../io/index.ts';

/** One run in full for people. */
export function simulatePretty(level: Level, runName: string, run: Run, report: RunReport, colors: Colors): string {
  const paint = run.outcome === 'completed' ? colors.green : colors.red;
  const { x, y, vx, vy, angle } = report.final;
  const near = run.clearance;
  const lines = [
    `${colors.bold(visibleLine(level.name))}, ${visibleLine(runName)}, ${report.accuracy}`,
    paint(outcomeInWords(run, level.range)),
    '',
    ...run.events.map((event) => `${event.time.toFixed(3).padStart(8)} s  ${eventInWords(event)}`),
    ...(run.events.length > 0 ? [''] : []),
    `holds      ${holdsInWords(report.holds)}`,
    `minerals   ${countMinerals(run)} of ${level.minerals.length}`,
    `clearance  ${near === null ? 'nothing deadly in the level' : `${near.distance.toFixed(3)} px to ${bodyInWords(near)} at ${near.time.toFixed(3)} s`}`,
    `final      x ${x.toFixed(3)}, y ${y.toFixed(3)} px; ${vx.toFixed(3)}, ${vy.toFixed(3)} px/s; angle ${angle.toFixed(4)} rad`,
    `hash       ${run.hash}`,
  ];
  if (report.samples.length > 0) {
    lines.push('', '       t s           x           y          vx          vy    angle');
    for (const [t, ...rest] of report.samples) {
      const cells = rest.map((value, i) => (i < 4 ? value.toFixed(3).padStart(12) : value.toFixed(4).padStart(9)));
      lines.push(t.toFixed(4).padStart(10) + cells.join(''));
    }
  }
  return `${lines.join('\n')}\n`;
}

function eventInWords(event: RunEvent): string {
  switch (event.type) {
    case 'press':
    case 'release':
      return event.type;
    case 'target':
      return `target: ${objectName('asteroid', event.index)}`;
    case 'mineral':
      return `${objectName('mineral', event.index)} collected`;
    case 'enter':
    case 'leave':
      return `${event.type}s the field of ${objectName('repulsor', event.index)}`;
    case 'effect':
      return effectEventInWords(event);
    case 'wake':
      return `${objectName('alien', event.index)} wakes`;
    case 'sleep':
      return `${objectName('alien', event.index)} falls asleep`;
    case 'explosion':
      return `${event.aliens.map((index) => objectName('alien', index)).join(' and ')} explode`;
    case 'completed':
    case 'collided':
    case 'lost':
      return event.with === null ? event.type : `${event.type}: touches ${bodyInWords(event.with)}`;
  }
}

import { cpus, totalmem } from 'node:os';
import type { Bench, Limit, Report } from './record.ts';

// results of contestants end up here and are printed, so that no compiler can drop the work
let sink = 0;

/** Keeps a result alive. */
export function consume(value: number): void {
  sink = (sink + value) % 1e9;
}

/** A claim with what was measured. */
export interface Verdict extends Limit {
  readonly measured: number;
  readonly met: boolean;
}

/** Whether a figure keeps to its limit; one that is no number does not. */
export const keeps = ({ bound, limit }: Limit, measured: number): boolean =>
  bound === 'at most' ? measured <= limit : measured >= limit;

/** The claims of a benchmark that were measured, in their order. */
export function verdictsOf({ claims }: Bench, { measured }: Report): Verdict[] {
  return Object.entries(claims).flatMap(([key, claim]) => {
    const found = measured[key];
    if (found === null) return [];
    const figures = typeof found === 'number' ? [['', found] as const] : Object.entries(found);
    return figures.map(([of, value]) => ({
      ...claim,
      what: of === '' ? claim.what : `${of}: ${claim.what}`,
      measured: value,
      met: keeps(claim, value),
    }));
  });
}

/** The machine and the runtime that the figures come from. */
export function machine(): { cpu: string; cores: number; memory: string; node: string; v8: string; platform: string } {
  const all = cpus();
  return {
    cpu: all[0]?.model.trim() ?? 'unknown',
    cores: all.length,
    memory: `${Math.round(totalmem() / 2 ** 30)} GiB`,
    node: process.version,
    v8: process.versions.v8,
    platform: `${process.platform} ${process.arch}`,
  };
}

/** Four significant digits, without an exponent where it is readable without. */
export function figure(value: number): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}

/** Lines of a table, the first column to the left and the others to the right. */
export function tableOf({ columns, rows }: Pick<Report, 'columns' | 'rows'>): string[] {
  const cells = rows.map((row) => row.map((cell) => (typeof cell === 'number' ? figure(cell) : (cell ?? '-'))));
  const widths = columns.map((column, i) => Math.max(column.length, ...cells.map((row) => row[i].length)));
  const line = (row: readonly string[]) =>
    row
      .map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i])))
      .join('  ')
      .trimEnd();
  return [line(columns), widths.map((width) => '-'.repeat(width)).join('  '), ...cells.map(line)];
}

/**
 * Prints a report as a table, or as JSON.
 * @returns whether every claim was met
 */
export function publish(bench: Bench, report: Report, asJson: boolean): boolean {
  const claims = verdictsOf(bench, report);
  const m = machine();
  const { title, columns, rows, notes } = report;
  if (asJson) console.log(JSON.stringify({ title, columns, rows, claims, notes, machine: m, sink }, null, 2));
  else {
    console.log(`${title}\n${m.cpu}, ${m.cores} cores, ${m.memory}, ${m.platform}, Node ${m.node} (V8 ${m.v8})\n`);
    for (const line of tableOf(report)) console.log(line);
    if (claims.length > 0) console.log('');
    for (const { what, bound, limit, measured, met } of claims) {
      console.log(`${met ? 'met    ' : 'NOT MET'}  ${what}: ${figure(measured)} (${bound} ${figure(limit)})`);
    }
    for (const note of notes) console.log(`\n${note}`);
  }
  return claims.every(({ met }) => met);
}

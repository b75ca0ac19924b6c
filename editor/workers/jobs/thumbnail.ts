import { compile, simulate } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { readLevel } from '../../../schema/index.ts';
import { proveImpossible, verifyProof } from '../../../solver/index.ts';
import type { Start } from '../work.ts';

/** Draws a level file small, with a run that completes it where it has one. */
export const thumbnail: Start<'thumbnail'> = function* ({ text, accuracy, width, theme }) {
  const reading = readLevel(text, { byteOrderMark: 'skip' });
  if (!reading.ok) return { svg: '', verdict: 'invalid', minerals: 0 };
  const { level } = reading;
  const scene = compile(level, accuracy);
  let shown = level.runs.length === 0 ? undefined : simulate(scene, level.runs[0].holds);
  for (const { holds } of level.runs.slice(1)) {
    if (shown?.outcome === 'completed') break;
    yield null;
    const run = simulate(scene, holds);
    if (run.outcome === 'completed') shown = run;
  }
  const isCompleted = shown?.outcome === 'completed';
  if (!isCompleted) yield null;
  const proof = isCompleted ? null : proveImpossible(level, { accuracy });
  const isImpossible = proof !== null && verifyProof(level, proof).ok;
  const otherwise = shown === undefined ? 'unproven' : 'broken';
  const verdict = isCompleted ? 'completable' : isImpossible ? 'impossible' : otherwise;
  const minerals = new Set(shown?.minerals.map(({ index }) => index)).size;
  return { svg: renderSvg(level, { run: shown, width, theme, words: false }), verdict, minerals };
};

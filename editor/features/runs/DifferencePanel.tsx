import { ArrowRightToLine } from 'lucide-react';
import { type Better, type Comparison, type HoldPair, pairInWords, partingsInWords } from '../../../check/runs/index.ts';
import { useEditor, useProof } from '../../core/context/index.ts';
import { plural, seconds } from '../../core/figures/index.ts';
import { outcomeWord } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { useDifference } from '../compare/index.ts';
import './difference.css';

/** More holds than this are not listed. */
const MOST_HOLDS = 60;

const SIGNS: Readonly<Record<'better' | 'worse' | 'same', readonly [sign: string, word: string]>> = {
  better: ['▲', 'better'],
  worse: ['▼', 'worse'],
  same: ['', ''],
};

const signOf = (better: Better, side: 'one' | 'other') => SIGNS[better === null ? 'same' : better === side ? 'better' : 'worse'];

const holdOf = (hold: HoldPair['one']): string => (hold === null ? '–' : `${hold[0]}-${hold[1]}`);
const shiftOf = (ticks: number | null): string =>
  ticks === null ? '' : ticks === 0 ? '0' : `${ticks > 0 ? '+' : '−'}${Math.abs(ticks)}`;

/** The difference of the shown run and the chosen compared one, in words and tables; nothing while no run is compared. */
export function DifferencePanel() {
  const { commands } = useEditor();
  const known = useDifference(true);
  const minerals = useProof((proof) => proof.level.minerals.length);
  if (known === null) return null;
  const { shown, row, difference, partings, isStale } = known;
  const names = [shown, row.name] as const;
  const px = (value: number | null) => (value === null ? '–' : `${value.toFixed(1)} px`);
  const figures: readonly (readonly [what: string, of: Comparison<unknown>, one: string, other: string])[] = [
    ['outcome', difference.outcome, outcomeWord(difference.outcome.one), outcomeWord(difference.outcome.other)],
    ['time', difference.time, seconds(difference.time.one), seconds(difference.time.other)],
    ...(minerals === 0
      ? []
      : [['minerals', difference.minerals, String(difference.minerals.one), String(difference.minerals.other)] as const]),
    ['clearance', difference.clearance, px(difference.clearance.one), px(difference.clearance.other)],
    ['slack', difference.slack, slackOf(difference.slack.one), slackOf(difference.slack.other)],
  ];
  const cell = (text: string, better: Better, side: 'one' | 'other') => {
    const [sign, word] = signOf(better, side);
    return (
      <td className={word === '' ? 'numbers' : `numbers difference__${word}`}>
        {text} {sign !== '' && <span aria-hidden>{sign}</span>}
        {word !== '' && <span className="unseen">{word}</span>}
      </td>
    );
  };
  return (
    <section className={isStale ? 'difference difference--stale' : 'difference'} aria-label="Difference of two runs">
      <div className="difference__head">
        <h3 className="panel__title">
          {shown} and {row.name}
        </h3>
        <Button
          hint="Go to where they part"
          shortcut="P"
          icon={<ArrowRightToLine size={14} />}
          disabled={partings.parts === null}
          onClick={() => commands.run('compare.parting')}
        />
      </div>
      <p className="difference__words" role="status" aria-label="Where the runs part">
        {isStale ? 'The level has changed: the difference follows.' : partingsInWords(difference, partings)}
      </p>
      <table className="difference__table">
        <thead>
          <tr>
            <th scope="col">
              <span className="unseen">figure</span>
            </th>
            <th scope="col">{shown}</th>
            <th scope="col">{row.name}</th>
          </tr>
        </thead>
        <tbody>
          {figures.map(([what, { better }, one, other]) => (
            <tr key={what}>
              <th scope="row">{what}</th>
              {cell(one, better, 'one')}
              {cell(other, better, 'other')}
            </tr>
          ))}
        </tbody>
      </table>
      <table className="difference__table">
        <caption className="unseen">Holds in order of time, and how much later {row.name} presses and releases, in ticks</caption>
        <thead>
          <tr>
            <th scope="col">{shown}</th>
            <th scope="col">{row.name}</th>
            <th scope="col">press</th>
            <th scope="col">release</th>
          </tr>
        </thead>
        <tbody>
          {difference.holds.slice(0, MOST_HOLDS).map((pair) => (
            <tr key={`${pair.one?.join()} ${pair.other?.join()}`} title={pairInWords(pair, names)}>
              <td className="numbers">{holdOf(pair.one)}</td>
              <td className="numbers">{holdOf(pair.other)}</td>
              {pair.press === null ? (
                <td colSpan={2}>{pairInWords(pair, names)}</td>
              ) : (
                <>
                  <td className="numbers">{shiftOf(pair.press)}</td>
                  <td className="numbers">{shiftOf(pair.release)}</td>
                </>
              )}
            </tr>
          ))}
        </tbody>
      </table>
      {difference.holds.length > MOST_HOLDS && <p>And {plural(difference.holds.length - MOST_HOLDS, 'hold')} more.</p>}
    </section>
  );
}

const slackOf = (ticks: number | null): string => (ticks === null ? '–' : plural(ticks, 'tick'));

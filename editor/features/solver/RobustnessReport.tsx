import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import type { EdgeSlack, Success } from '../../../solver/index.ts';
import { useEditor, useLevel, useProof } from '../../core/context/index.ts';
import { percent, plural, SLACK_LIMIT, slackText, tightestOf } from '../../core/figures/index.ts';
import { Section, Trouble } from '../../core/panel/index.ts';
import { useSolverSession } from './index.ts';

/** How much the timing of the shown run may be off. */
export function RobustnessReport() {
  const { robustness } = useSolverSession();
  const { phase, slack, p40, full, withMinerals, message } = useStore(robustness.store);
  const name = useProof(({ run }) => run.name);
  const taken = useProof(({ run }) => run.minerals.length);
  const edges = useProof(({ run }) => 2 * run.holds.length);
  const isBusy = phase === 'waiting' || phase === 'measuring';
  return (
    <Section
      title="Robustness"
      aside={
        isBusy &&
        name !== null && <span className="part__note">{full === null && p40 !== null ? 'certifying…' : 'measuring…'}</span>
      }
    >
      {phase === 'failed' && <Trouble>The measurement failed: {message}. Change the run to try again.</Trouble>}
      {phase === 'fails' && (
        <p className="part__note">
          {name === null ? 'There is no run yet.' : 'The run does not complete the level, so there is nothing to measure.'}
        </p>
      )}
      {taken > 0 && (
        <label className="report__heat">
          <input type="checkbox" checked={withMinerals} onChange={(event) => robustness.setWithMinerals(event.target.checked)} />
          Must also collect its {plural(taken, 'mineral')}
        </label>
      )}
      {full !== null ? (
        <>
          <dl className="chances" aria-label="Success under timing noise of every press and release">
            {[full.p30, full.p40, full.p60, full.p80].map((success) => (
              <Chance key={success.sigma} success={success} />
            ))}
          </dl>
          <p>
            {full.certifiedTicks > 0 ? (
              <>
                <b className="tone--good">Certified for {plural(full.certifiedTicks, 'tick')}</b>: all presses and releases off by
                up to {msOf(full.certifiedTicks)} ms, in every combination, succeed.
                {!full.decided && ' Larger shifts were too many to check.'}
              </>
            ) : edges > 0 ? (
              <>
                <b className="tone--warn">Not certified</b>:{' '}
                {full.decided
                  ? 'some combination of presses and releases off by one tick (17 ms) fails.'
                  : 'there are too many combinations of presses and releases off by one tick (17 ms) to check.'}
              </>
            ) : (
              'The run has no holds, so nothing can be mistimed.'
            )}
          </p>
        </>
      ) : (
        p40 !== null && (
          <dl className="chances">
            <Chance success={p40} />
          </dl>
        )
      )}
      {slack !== null && slack.length === edges && edges > 0 && <SlackTable slack={slack} />}
    </Section>
  );
}

function Chance({ success }: { readonly success: Success }) {
  const { sigma, p, low, high, samples } = success;
  const [word, tone] = wordFor(p);
  const text = `${percent(p)}, between ${percent(low)} and ${percent(high)}`;
  return (
    <div className="chance" title={`${text} with 95 % confidence; ${samples.toLocaleString('en')} attempts simulated`}>
      <dt className="numbers">{sigma} ms</dt>
      <dd>
        <span className="chance__bar" aria-hidden>
          <span className={`chance__fill chance__fill--${tone}`} style={{ width: `${100 * p}%` }} />
          <span className="chance__doubt" style={{ left: `${100 * low}%`, width: `${100 * (high - low)}%` }} />
        </span>
        <span className="chance__text numbers">{percent(p)}</span>
        <span className="unseen">
          , {word}, between {percent(low)} and {percent(high)}
        </span>
      </dd>
    </div>
  );
}

/** How forgiving a success rate is, as a word beside its number. */
const wordFor = (p: number): readonly [word: string, tone: 'good' | 'warn' | 'bad'] =>
  p >= 0.9 ? ['forgiving', 'good'] : p >= 0.5 ? ['thin', 'warn'] : ['risky', 'bad'];

/** The slack of each press and release alone. */
function SlackTable({ slack }: { readonly slack: readonly EdgeSlack[] }) {
  const { session } = useEditor();
  const { selection } = useLevel();
  const name = useProof(({ run }) => run.name);
  const holds = useProof(({ run }) => run.holds);
  const tightest = tightestOf(slack)?.room ?? 0;
  return (
    <table className="slack numbers">
      <caption className="part__note">How many ticks (1/60 s) each press or release alone may move earlier or later</caption>
      <thead>
        <tr>
          <th scope="col">hold</th>
          <th scope="col">press</th>
          <th scope="col">release</th>
        </tr>
      </thead>
      <tbody>
        {holds.map(([press, release], i) => (
          <tr key={press}>
            <th scope="row">
              <button
                type="button"
                className="facts__moment"
                title="Select this hold"
                onClick={() => {
                  if (name === null) return;
                  selection.selectHolds(name, [i]);
                  session.setState({ tick: press, isPlayingBack: false });
                }}
              >
                {press}–{release}
              </button>
            </th>
            {[slack[2 * i], slack[2 * i + 1]].map((edge, k) => {
              if (edge === undefined) return null;
              const isTightest = edge.earlier + edge.later === tightest && tightest < 2 * SLACK_LIMIT;
              return (
                <td
                  // press first, then release
                  // biome-ignore lint/suspicious/noArrayIndexKey: there are always these two
                  key={k}
                  className={isTightest ? 'tone--warn' : undefined}
                  title={`${msOf(edge.earlier)} ms earlier, ${msOf(edge.later)} ms later${isTightest ? ': the tightest' : ''}`}
                >
                  −{slackText(edge.earlier)} +{slackText(edge.later)}
                  {isTightest && <span className="unseen"> the tightest</span>}
                </td>
              );
            })}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

const msOf = (ticks: number): number => Math.round(1000 * ticks * TICK);

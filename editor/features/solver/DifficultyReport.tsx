import { Gauge, Plus, Square } from 'lucide-react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import type { Candidate, Difficulty, WithoutAsteroid } from '../../../solver/index.ts';
import { extraInWords, type Fact, percent, plural, seconds } from '../../core/figures/index.ts';
import { Facts, Progress, Section, Trouble } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { useSolverSession } from './index.ts';

/** How hard the level is, measured on demand. */
export function DifficultyReport() {
  const { difficulty } = useSolverSession();
  const { phase, result, run, asked, isOld, message } = useStore(difficulty.store);
  return (
    <Section
      title="Difficulty"
      aside={
        phase === 'measuring' ? (
          <Button hint="Stop measuring" icon={<Square size={13} />} onClick={difficulty.cancel}>
            Cancel
          </Button>
        ) : (
          <Button hint="Measure grade and shortcuts; takes some seconds" icon={<Gauge size={14} />} onClick={difficulty.start}>
            {result === null ? 'Measure' : 'Measure again'}
          </Button>
        )
      }
    >
      {(phase === 'measuring' || result !== null) && <Progress label="Measuring" isRunning={phase === 'measuring'} />}
      {phase === 'failed' && <Trouble>The measurement failed: {message}. Try again.</Trouble>}
      {phase === 'none' && (
        <p className="part__note">
          The shown run does not complete the level{asked}, and no run that does was found in the time set above. This does not
          prove that there is none. Show a run that does, or allow more seconds.
        </p>
      )}
      {result !== null && phase !== 'none' && (
        <div className={isOld || phase === 'measuring' ? 'report report--old' : 'report'}>
          <p className="part__note">
            {isOld && 'Measured before the last change. '}
            {run === null ? `Measured with a run${asked} found by a search.` : `Measured with the run “${run}”${asked}.`}
          </p>
          <Result result={result} />
        </div>
      )}
      {result === null && phase === 'idle' && (
        <p className="part__note">A grade from 1 to 10, and possibly unintended shortcuts.</p>
      )}
    </Section>
  );
}

function Result({ result }: { readonly result: Difficulty }) {
  const { grade, shortcuts } = result;
  const { withoutPressing, onePress, withoutAsteroid } = shortcuts;
  return (
    <>
      <div className="grade">
        <span className="grade__value numbers">{grade.value.toFixed(1)}</span>
        <div className="grade__scale">
          <b>{grade.word}</b> <span className="part__note">of 10, an estimate</span>
          <meter className="grade__meter" min={0} max={10} value={grade.value} aria-label="Grade" />
        </div>
      </div>
      <Facts facts={factsOf(result)} />
      <h4 className="report__title">Shortcuts</h4>
      <ul className="report__shortcuts">
        {withoutPressing !== null && (
          <Shortcut
            text={`Without any press, the level is completed in ${seconds(withoutPressing.time)}`}
            run={withoutPressing}
            as="no press"
          />
        )}
        <Shortcut
          text={
            onePress.count === 0
              ? `None of ${onePress.tried.toLocaleString('en')} runs with one press completes it`
              : `${percent(onePress.count / onePress.tried)} of ${onePress.tried.toLocaleString('en')} runs with one press complete it`
          }
          run={onePress.example}
          as="one press"
        />
        {withoutAsteroid.map(({ asteroid, use, run }) => (
          <Shortcut
            key={asteroid}
            text={`Asteroid ${asteroid + 1} ${USES[use]}`}
            run={use === 'avoidable' ? run : null}
            as={`without asteroid ${asteroid + 1}`}
          />
        ))}
      </ul>
    </>
  );
}

function factsOf({ sigmaAtHalf, smallestWindow, presses, length, randomPlay, mineralsExtra, forecast }: Difficulty): Fact[] {
  const facts: Fact[] = [
    { label: 'length', value: `${seconds(length)}, ${plural(presses, 'press', 'presses')}` },
    { label: 'half of the attempts fail at', value: `${sigmaAtHalf.capped ? '> ' : ''}${sigmaAtHalf.ms.toFixed(0)} ms of noise` },
  ];
  if (smallestWindow !== null) facts.push({ label: 'tightest window', value: `${(1000 * smallestWindow * TICK).toFixed(0)} ms` });
  facts.push({
    label: 'random play completes',
    value: `${percent(randomPlay.share)} of ${randomPlay.samples.toLocaleString('en')}`,
  });
  if (forecast !== null) {
    const first = percent(forecast.attempts[0].pass.p);
    facts.push({ label: 'synthetic players pass at first', value: `${first}, not calibrated` });
  }
  if (mineralsExtra !== null) {
    const { time, presses: more } = mineralsExtra;
    facts.push({ label: 'collecting all minerals', value: extraInWords(time, more) });
  }
  return facts;
}

/** A possibly unintended way to complete the level, with a button that keeps it as a run. */
function Shortcut({ text, run, as }: { readonly text: string; readonly run: Candidate | null; readonly as: string }) {
  const { search } = useSolverSession();
  return (
    <li className="shortcut">
      <span>{text}</span>
      {run !== null && (
        <Button
          hint="Add it to the level as a run"
          icon={<Plus size={14} />}
          onClick={() => search.use(run.holds, undefined, as)}
        />
      )}
    </li>
  );
}

const USES: Readonly<Record<WithoutAsteroid['use'], string>> = {
  avoidable: 'can be left unused',
  replaceable: 'can be left out of the level',
  needed: 'is needed: without it the level is proved impossible',
  unknown: 'is most likely needed: no run without it was found',
};

import { Timer } from 'lucide-react';
import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { plural } from '../../../check/words/index.ts';
import type { EffectWork, Work } from '../../../engine/index.ts';
import { onDemand } from '../../core/ask/index.ts';
import { useEditor, useLevel, useProof, useProofInPace } from '../../core/context/index.ts';
import { type Fact, percent } from '../../core/figures/index.ts';
import { Facts, Section, Trouble } from '../../core/panel/index.ts';
import { limitInWords, withoutRuns } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { jobs, type TimedEffects } from '../../workers/index.ts';
import { type SimulatedEffect, type Survey, surveyOf } from './survey.ts';

/** ms: the run is played once more, to count */
const WAIT = 300;

/** The effects that the level calls for and those it does not, and what each costs in the shown run. */
export function Effects() {
  const survey = useProofInPace(surveyOf, WAIT);
  const limit = useProof((proof) => proof.limit);
  if (survey !== null) return <Surveyed survey={survey} />;
  return <p className="panel__body part__note">{limit === null ? 'Loading…' : limitInWords(limit)}</p>;
}

/** What each effect takes of a run's time. */
export const effectsQuestion = onDemand(jobs.effects);

function Surveyed({ survey }: { readonly survey: Survey }) {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const [measured, setMeasured] = useState<{ readonly key: string; readonly timed: TimedEffects } | null>(null);
  const question = useMemo(() => effectsQuestion(desk), [desk]);
  useEffect(() => question.close, [question]);
  const { phase, message } = useStore(question.store);
  const { simulated, notCalledFor, key } = survey;
  const timed = measured?.key === key ? measured.timed : null;

  const measure = () => {
    const now = proof.proof();
    const asked = surveyOf(now);
    if (asked === null) return;
    question.ask({ level: withoutRuns(now.level), terms: now.terms, holds: now.run.holds }, ({ answer }) => {
      if (answer !== null) setMeasured({ key: asked.key, timed: answer });
    });
  };
  const isMeasuring = phase === 'asking';
  const canMeasure = simulated.some(({ work }) => work !== null);

  return (
    <div className="panel__body effects">
      <Section
        title="Simulated"
        aside={
          canMeasure && (
            <Button
              hint={isMeasuring ? 'Stop' : "Measure for two seconds, in a worker, what each effect takes of the run's time"}
              icon={<Timer size={14} />}
              onClick={isMeasuring ? question.forget : measure}
            >
              {isMeasuring ? 'Cancel' : 'Measure time'}
            </Button>
          )
        }
      >
        {phase === 'failed' && <Trouble>The measurement failed: {message}. Try again.</Trouble>}
        <ul className="effects__list" aria-label="Simulated effects">
          {simulated.map((effect) => (
            <EffectRow key={effect.name} effect={effect} survey={survey} timed={timed} />
          ))}
        </ul>
      </Section>
      {notCalledFor.length > 0 && (
        <Section title="Not simulated">
          <ul className="effects__list" aria-label="Effects that are not simulated">
            {notCalledFor.map(({ name, because, summary }) => (
              <li key={name} className="effect effect--off" title={summary}>
                <b>{name}</b> <span className="part__note">{because}</span>
              </li>
            ))}
          </ul>
        </Section>
      )}
      <Section title={survey.runName === null ? 'How the drift spends its time' : `How “${survey.runName}” spends its time`}>
        <Modes survey={survey} />
      </Section>
      <Section title="Work of the run">
        <Facts facts={workFacts(survey)} />
      </Section>
    </div>
  );
}

interface EffectRowProps {
  readonly effect: SimulatedEffect;
  readonly survey: Survey;
  readonly timed: TimedEffects | null;
}

function EffectRow({ effect: { name, because, summary, work }, survey, timed }: EffectRowProps) {
  const time = timed?.effects.find((effect) => effect.name === name)?.time;
  return (
    <li className="effect">
      <p className="effect__head">
        <b>{name}</b> <span className="part__note">{because}</span>
      </p>
      <p className="part__note">{summary}</p>
      {work !== null && (
        <span className="effect__bar" aria-hidden title="its share of the guards">
          <span style={{ width: `${(100 * work.guards) / Math.max(1, survey.work.guards)}%` }} />
        </span>
      )}
      <p className="effect__cost numbers">{work === null ? 'examined once a frame' : countText(work, survey.work)}</p>
      {timed !== null && time !== undefined && <p className="effect__cost numbers">{timeText(time, timed.whole)}</p>}
    </li>
  );
}

/** What an effect costs, in counts: `118 of 430 guards, 2 roots, 1 event`. */
const countText = ({ guards, roots, events }: EffectWork, work: Work): string =>
  `${guards} of ${plural(work.guards, 'guard', 'guards')}, ${plural(roots, 'root', 'roots')}, ${plural(events, 'event', 'events')}`;

const timeText = (time: number | null, whole: number): string =>
  time === null
    ? 'not timed: the run takes too long'
    : `${percent(time / whole)} of the time: ${digits(time)} of ${digits(whole)} µs per simulated second`;

const digits = (value: number): number => Number(value.toPrecision(2));

/** How the time of the run is divided, as a bar and in words. */
function Modes({ survey }: { readonly survey: Survey }) {
  const modes = [...survey.modes].sort((a, b) => b.share - a.share);
  return (
    <>
      <div className="modes" aria-hidden>
        {modes.map(({ name, share }, i) => (
          <span key={name} className={`modes__part modes__part--${i % 5}`} style={{ flexGrow: share }} title={name} />
        ))}
      </div>
      <ul className="modes__list numbers">
        {modes.map(({ name, share }, i) => (
          <li key={name}>
            <span className={`modes__sign modes__part--${i % 5}`} aria-hidden /> {name} {percent(share)}
          </li>
        ))}
      </ul>
    </>
  );
}

function workFacts({ work, time }: Survey): Fact[] {
  const each = (count: number) => `${count.toLocaleString('en')} (${(count / Math.max(time, 1e-9)).toFixed(1)} per second)`;
  return [
    { label: 'pieces of motion', value: each(work.pieces) },
    { label: 'force evaluations', value: each(work.forceEvaluations) },
    { label: 'guards watched', value: each(work.guards) },
    { label: 'roots found', value: each(work.roots) },
  ];
}

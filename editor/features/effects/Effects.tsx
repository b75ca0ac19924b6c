import { Timer } from 'lucide-react';
import { useEffect, useState } from 'react';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { inSlices } from '../../core/ask/index.ts';
import { useLevel, useProof, useProofInPace } from '../../core/context/index.ts';
import { type Fact, percent } from '../../core/figures/index.ts';
import { Facts, Section } from '../../core/panel/index.ts';
import { limitInWords } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { type EffectTime, type SimulatedEffect, type Survey, surveyOf, timeEffects } from './survey.ts';

/** ms: each effect that can be left out is one more run to simulate */
const WAIT = 300;

/** The effects that the level calls for and those it does not, and what each costs in the shown run. */
export function Effects() {
  const survey = useProofInPace(surveyOf, WAIT);
  const limit = useProof((proof) => proof.limit);
  if (survey !== null) return <Surveyed survey={survey} />;
  return <p className="panel__body part__note">{limit === null ? 'Loading…' : limitInWords(limit)}</p>;
}

function Surveyed({ survey }: { readonly survey: Survey }) {
  const { proof } = useLevel();
  const [measured, setMeasured] = useState<{ readonly key: string; readonly times: Times } | null>(null);
  /** Stops a measurement; null: there is none. */
  const [stop, setStop] = useState<(() => void) | null>(null);
  useEffect(() => stop ?? undefined, [stop]);
  const { simulated, notCalledFor, key } = survey;
  const times = measured?.key === key ? measured.times : null;

  const measure = () => {
    const { level, terms, run } = proof.proof();
    const asked = surveyOf(proof.proof());
    if (asked === null) return;
    const without = new Map(
      asked.simulated.flatMap(({ name, cost }) => (cost.kind === 'same' ? [[name, cost.level] as const] : [])),
    );
    const onDone = (found: Times) => {
      setStop(null);
      setMeasured({ key: asked.key, times: found });
    };
    const measuring = inSlices(timeEffects(level, terms, run.holds, without), { wait: 0, slice: 0, onDone });
    setStop(() => measuring);
  };
  const canMeasure = simulated.some(({ cost }) => cost.kind === 'same');

  return (
    <div className="panel__body effects">
      <Section
        title="Simulated"
        aside={
          canMeasure && (
            <Button
              hint={stop !== null ? 'Stop' : 'Time the run with and without each effect, in this page'}
              icon={<Timer size={14} />}
              onClick={() => (stop === null ? measure() : setStop(null))}
            >
              {stop === null ? 'Measure time' : 'Cancel'}
            </Button>
          )
        }
      >
        <ul className="effects__list" aria-label="Simulated effects">
          {simulated.map((effect) => (
            <EffectRow key={effect.name} effect={effect} survey={survey} time={times?.get(effect.name)} />
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

type Times = ReadonlyMap<string, EffectTime>;

function EffectRow({ effect, survey, time }: { effect: SimulatedEffect; survey: Survey; time: EffectTime | undefined }) {
  const { proof } = useLevel();
  const { name, because, summary, cost } = effect;
  const share = cost.kind === 'same' ? Math.max(0, cost.saved.guards / Math.max(1, survey.work.guards)) : null;
  return (
    <li className="effect">
      <p className="effect__head">
        <b>{name}</b> <span className="part__note">{because}</span>
      </p>
      <p className="part__note">{summary}</p>
      {share !== null && (
        <span className="effect__bar" aria-hidden title="its share of the guards">
          <span style={{ width: `${100 * share}%` }} />
        </span>
      )}
      <p className="effect__cost numbers">{countText(effect, survey, proof.proof().level.range)}</p>
      {time !== undefined && cost.kind === 'same' && <p className="effect__cost numbers">{timeText(time)}</p>}
    </li>
  );
}

/** the cost in counts: `118 of 430 guards` */
function countText({ name, cost }: SimulatedEffect, { work }: Survey, range: number): string {
  if (cost.kind === 'always') return name === 'alien-explosion' ? 'part of the aliens: see alien-chase' : 'always simulated';
  if (cost.kind === 'other') return `without it the run differs: she ${outcomeAsPredicate(cost.run, range)}`;
  const parts = (['guards', 'pieces', 'roots'] as const)
    .filter((what) => cost.saved[what] !== 0)
    .map((what) => `${cost.saved[what]} of ${work[what]} ${what}`);
  return parts.length === 0 ? 'no cost in this run' : parts.join(', ');
}

function timeText({ all, saved, low, high }: EffectTime): string {
  const between = `${low.toFixed(2)} to ${high.toFixed(2)} in the two halves of the rounds`;
  if (low <= 0) return `time: too small to measure (${between}, µs per simulated second)`;
  return `time: ${saved.toFixed(2)} of ${all.toFixed(2)} µs per simulated second, ${percent(saved / all)} (${between})`;
}

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

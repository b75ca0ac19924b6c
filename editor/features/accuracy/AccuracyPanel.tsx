import { Check, Gauge, Square, X } from 'lucide-react';
import type { ComponentType } from 'react';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName } from '../../../engine/index.ts';
import { unmeasuredInWords } from '../../../picture/accuracy/index.ts';
import { useEditor, usePageTerms, useProof } from '../../core/context/index.ts';
import { pixels } from '../../core/figures/index.ts';
import { Progress, Section, Trouble } from '../../core/panel/index.ts';
import { playsAlike } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import { holdsOfAll, NAMES, useMeasured, useNamedResults } from './measured-settings.ts';
import { WorkPrecision } from './WorkPrecision.tsx';

/** The results and costs of the named settings for this level and run; selects the one in use. */
export function AccuracyPanel({ sections }: { readonly sections: readonly ComponentType[] }) {
  const terms = usePageTerms();
  const current = accuracyNameOf(terms.shown);
  const { settings, knownTo, doubt, unmeasured, isFresh } = useNamedResults();
  const { phase, message, measured, start, cancel } = useMeasured();
  const isAlike = useProof((proof) => measured !== null && playsAlike(measured.played, proof));
  const holds = useProof(holdsOfAll);
  const isOld = measured !== null && (measured.holds !== holds || !isAlike);
  return (
    <div className="panel__body accuracies">
      <Section
        title="All settings"
        aside={
          phase === 'measuring' ? (
            <Button hint="Stop measuring" icon={<Square size={13} />} onClick={cancel}>
              Cancel
            </Button>
          ) : (
            <Button hint="Time all settings on the runs of this level, in a worker" icon={<Gauge size={14} />} onClick={start}>
              {measured === null ? 'Measure' : 'Measure again'}
            </Button>
          )
        }
      >
        {(phase === 'measuring' || measured !== null) && <Progress label="Measuring" isRunning={phase === 'measuring'} />}
        {phase === 'failed' && <Trouble>The measurement failed: {message}. Try again.</Trouble>}
        {measured === null ? (
          phase === 'idle' && (
            <p className="part__note">
              Times and errors of 59 settings on the runs of this level: the work-precision diagram, with the one in use ringed.
            </p>
          )
        ) : (
          <>
            {isOld && <p className="part__note">Measured before the last change of the level or its run.</p>}
            <WorkPrecision measured={measured} current={current} />
            {measured.left > 0 && (
              <p className="part__note">
                The first {measured.runs.length} of {measured.runs.length + measured.left} runs.
              </p>
            )}
            {measured.runs.map(({ name, doubt: own, unmeasured: over }) => (
              <Caveats key={name} of={measured.runs.length > 1 ? name : null} doubt={own} unmeasured={over} />
            ))}
          </>
        )}
      </Section>
      <Section title="Named settings" aside={!isFresh && <span className="part__note">comparing…</span>}>
        <div
          className={isFresh ? 'accuracies__list' : 'accuracies__list accuracies__list--old'}
          role="radiogroup"
          aria-label="Accuracy"
        >
          {NAMES.map((name) => (
            <Choice
              key={name}
              name={name}
              result={settings.find((setting) => setting.name === name)}
              knownTo={knownTo}
              isCurrent={name === current}
              isOfFolder={name === terms.folder.accuracy.name}
            />
          ))}
        </div>
        <p className="part__note">
          Off by: the largest distance, at any tick, to a reference with 32 digits of another method
          {knownTo === null ? '' : `, which is known to ${pixels(knownTo)}`}. µs/s: time per simulated second, timed in this
          browser. The setting in use applies to this level: to its verdict, the playtest and the solver. The list, the pack and
          publishing say what gq check says here.
        </p>
        <Caveats of={null} doubt={doubt} unmeasured={unmeasured} />
      </Section>
      {sections.map((Part, i) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the list never changes
        <Part key={i} />
      ))}
    </div>
  );
}

interface CaveatsProps extends Pick<ReturnType<typeof useNamedResults>, 'doubt' | 'unmeasured'> {
  /** The run that they are about; null: there is only one. */
  readonly of: string | null;
}

/** What is not known of a run, and why. */
function Caveats({ of, doubt, unmeasured }: CaveatsProps) {
  const maxWork = usePageTerms().shown.maxWork;
  const lines = unmeasuredInWords(maxWork, unmeasured);
  if (doubt !== null)
    lines.unshift(`The reference is in doubt: ${doubt}. Errors in brackets are no more than differences from that run.`);
  return lines.map((line) => (
    <p key={line} className="part__note tone--warn">
      {of === null ? '' : `${of}: `}
      {line}
    </p>
  ));
}

const ABOUT: Readonly<Record<AccuracyName, string>> = {
  arcade: 'the original game, frame by frame, quirks included',
  fast: 'Verlet at 60 Hz, contacts swept',
  standard: 'Runge-Kutta at 60 Hz, contacts swept',
  precise: `error held below ${ACCURACIES.precise.tolerance} px per second, contacts swept`,
};

interface ChoiceProps {
  readonly name: AccuracyName;
  readonly result: ReturnType<typeof useNamedResults>['settings'][number] | undefined;
  /** How exactly the reference is known, px. */
  readonly knownTo: number | null;
  readonly isCurrent: boolean;
  /** Whether `gq check` judges the folder at it. */
  readonly isOfFolder: boolean;
}

function Choice({ name, result, knownTo, isCurrent, isOfFolder }: ChoiceProps) {
  const cost = result?.cost;
  const { settings } = useEditor();
  const range = useProof(({ level }) => level.range);
  return (
    <label className={isCurrent ? 'accuracy accuracy--current' : 'accuracy'}>
      <input
        type="radio"
        name="accuracy"
        value={name}
        checked={isCurrent}
        onChange={() => settings.setState({ otherAccuracy: isOfFolder ? null : name })}
      />
      <span className="accuracy__head">
        <b>{name}</b>
        {isCurrent && <span className="accuracy__tag">in use</span>}
        {isOfFolder && <span className="accuracy__tag accuracy__tag--quiet">gq check here</span>}
        <span className="accuracy__cost numbers">
          {cost === undefined ? '' : `${cost < 10 ? cost.toFixed(1) : cost.toFixed(0)} µs/s`}
        </span>
      </span>
      <span className="part__note">{ABOUT[name]}</span>
      {result !== undefined && (
        <span className="accuracy__result numbers">
          {result.sameVerdict ? (
            <Check size={13} className="tone--good" aria-label="same verdict:" />
          ) : (
            <X size={13} className="tone--bad" aria-label="different verdict:" />
          )}
          <span>{outcomeAsPredicate(result, range)}</span>
          <span className="accuracy__off">
            {knownTo === null
              ? `off by (${pixels(result.error)})`
              : `off by ${result.error < knownTo ? `less than ${pixels(knownTo)}` : pixels(result.error)}`}
          </span>
        </span>
      )}
    </label>
  );
}

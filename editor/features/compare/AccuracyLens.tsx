import { Layers } from 'lucide-react';
import { useStore } from 'zustand';
import { decidedInWords, waysInWords } from '../../../check/runs/index.ts';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName } from '../../../engine/index.ts';
import { useEditor, useLevel, usePageTerms, useProof } from '../../core/context/index.ts';
import { titled } from '../../core/document/index.ts';
import { Section } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import { comparedOf, sourceKey } from './compared.ts';
import { useComparedRows, useDifference } from './compared-rows.ts';

/** From the coarsest to the finest. */
const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** The shown run at all accuracies at once, on the level and the timeline; a slider chooses whose difference is told. */
export function AccuracyLens() {
  const { commands } = useEditor();
  const store = comparedOf(useLevel());
  const isOn = useStore(store, ({ runs }) => runs.some(({ source }) => source.kind === 'accuracy'));
  return (
    <Section
      title="On the level"
      aside={
        <Button
          hint="Show this run at all accuracies at once, beside each other"
          icon={<Layers size={14} />}
          pressed={isOn}
          onClick={() => commands.run('compare.accuracies')}
        >
          All at once
        </Button>
      }
    >
      {isOn ? (
        <Lens />
      ) : (
        <p className="part__note">
          Draws this run as each accuracy plays it. Where one parts from the run by a pixel, its path glows.
        </p>
      )}
    </Section>
  );
}

function Lens() {
  const store = comparedOf(useLevel());
  const inUse = accuracyNameOf(usePageTerms().shown);
  const row = useComparedRows().find(({ isChosen, source }) => isChosen && source.kind === 'accuracy') ?? null;
  const difference = useDifference();
  const range = useProof(({ level }) => level.range);
  const own = useProof(({ run }) => outcomeAsPredicate(run, range));
  const name = row?.source.kind === 'accuracy' ? row.source.name : inUse;
  const choose = (to: AccuracyName) => {
    if (to !== inUse) store.setState({ chosen: sourceKey({ kind: 'accuracy', name: to }) });
  };
  const step = (from: number, to: number) => {
    // the accuracy in use has no difference to itself: the slider passes it
    const next = NAMES[to] === inUse ? to + Math.sign(to - from) : to;
    if (NAMES[next] !== undefined) choose(NAMES[next]);
  };
  const at = NAMES.indexOf(name);
  const found = row?.found ?? null;
  return (
    <div className="lens">
      <input
        type="range"
        className="lens__slider"
        aria-label="Accuracy to compare with"
        aria-valuetext={name}
        min={0}
        max={NAMES.length - 1}
        step={1}
        value={at}
        onChange={(event) => step(at, Number(event.target.value))}
      />
      <div className="lens__names" aria-hidden>
        {NAMES.map((one) => (
          <span key={one} className={one === name ? 'lens__name lens__name--chosen' : 'lens__name'}>
            {one}
            {one === inUse && ' (in use)'}
          </span>
        ))}
      </div>
      <p className="part__note" role="status" aria-label="What this accuracy changes">
        {found === null
          ? `${name} is being simulated.`
          : `${name} ${outcomeAsPredicate(found.end, range)}; ${inUse}, in use, ${own}.`}{' '}
        {difference !== null && difference.row.key === row?.key && (
          <>
            {waysInWords(difference.partings)}{' '}
            {difference.decided === null
              ? 'The same things happen in both, in the same order.'
              : `${titled(decidedInWords(difference.decided, inUse))}.`}
          </>
        )}
      </p>
    </div>
  );
}

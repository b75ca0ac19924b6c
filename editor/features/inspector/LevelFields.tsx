import { CircleDot, UserRound } from 'lucide-react';
import type { LevelFile } from '../../../schema/index.ts';
import { useEditor, useLevel, useProofInPace } from '../../core/context/index.ts';
import { ASTRONAUT, BLACK_HOLE, type LevelProperty, type ObjectKey, setLevelProperty } from '../../core/document/index.ts';
import type { Fact } from '../../core/figures/index.ts';
import { Facts, Section } from '../../core/panel/index.ts';
import { endInWords, isWhole, type LiveProof } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { FieldRow } from './FieldRow.tsx';
import { type Field, fieldsOf, valueOfLevel } from './fields.ts';
import { RuleFields } from './RuleFields.tsx';
import { wayFacts } from './run-facts.ts';

interface RunSummary {
  readonly name: string | null;
  readonly end: string;
  readonly isGood: boolean;
  readonly isKnown: boolean;
  readonly facts: readonly Fact[];
}

const summaryOf = (proof: LiveProof): RunSummary => ({
  name: proof.run.name,
  end: endInWords(proof),
  isGood: proof.run.outcome === 'completed',
  isKnown: isWhole(proof),
  // for a run that is cut short, they would only cover its beginning
  facts: isWhole(proof) ? wayFacts(proof) : [],
});

const setProperty = (key: string, value: Field['fallback']) => setLevelProperty(key as LevelProperty, value as never);

/**
 * The fields of the level itself, links to the astronaut and the black hole, the outcome of the shown run, and the level's
 * rules.
 */
export function LevelFields({ file }: { readonly file: LevelFile }) {
  const { commands } = useEditor();
  const { selection } = useLevel();
  const run = useProofInPace(summaryOf);
  const place = ({ x, y }: { readonly x: number; readonly y: number }) => `${Math.round(x)}, ${Math.round(y)}`;
  const links: readonly (readonly [key: ObjectKey, name: string, where: string, icon: React.ReactNode])[] = [
    [ASTRONAUT, 'Astronaut', place(file.astronaut), <UserRound key="icon" size={14} />],
    [BLACK_HOLE, 'Black hole', place(file.blackHole), <CircleDot key="icon" size={14} />],
  ];
  return (
    <>
      <Section title="Level">
        {fieldsOf('level').fields.map((field) => (
          <FieldRow key={field.key} field={field} {...valueOfLevel(file, field)} whose="of the level" recipe={setProperty} />
        ))}
        <div className="links">
          {links.map(([key, name, where, icon]) => (
            <Button
              key={key}
              hint={`Select it and bring it into view`}
              look="outlined"
              icon={icon}
              onClick={() => {
                selection.select([key]);
                commands.run('view.fit-selection');
              }}
            >
              {name} <span className="numbers links__where">{where}</span>
            </Button>
          ))}
        </div>
      </Section>
      <Section title={run.name === null ? 'No run' : `Run “${run.name}”`}>
        {run.isKnown ? (
          <p className={run.isGood ? 'tone--good' : 'tone--bad'}>She {run.name === null ? `drifts and ${run.end}` : run.end}.</p>
        ) : (
          <p className="tone--warn">{run.end}.</p>
        )}
        <Facts facts={run.facts} />
      </Section>
      <RuleFields file={file} />
    </>
  );
}

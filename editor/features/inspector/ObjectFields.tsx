import {
  AlignCenterHorizontal,
  AlignCenterVertical,
  AlignEndHorizontal,
  AlignEndVertical,
  AlignHorizontalDistributeCenter,
  AlignStartHorizontal,
  AlignStartVertical,
  AlignVerticalDistributeCenter,
  CopyPlus,
  Crosshair,
  FlipHorizontal2,
  FlipVertical2,
  Grid3x3,
  RotateCw,
  Scaling,
  Trash2,
} from 'lucide-react';
import { memo, useCallback, useMemo, useState } from 'react';
import { type FieldName, KINDS, type ObjectKind } from '../../../schema/index.ts';
import { objectChanges, transformActions } from '../../canvas/index.ts';
import { useEditor, useLevel, useProofInPace } from '../../core/context/index.ts';
import {
  type FoundObject,
  marksOf,
  nameOf,
  type ObjectKey,
  objectsOf,
  ownNameOf,
  radiusOf,
  setObjectProperty,
  unlocked,
} from '../../core/document/index.ts';
import { type Fact, plural } from '../../core/figures/index.ts';
import { Facts, Section } from '../../core/panel/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import { FieldRow } from './FieldRow.tsx';
import { aboutObject, type Field, sharedFields, valueOfObjects } from './fields.ts';
import { MarkButtons, MarkNotes, NameRow } from './ObjectMarks.tsx';
import { runFactsOf } from './run-facts.ts';

/** Commands of the canvas for several objects. */
const ARRANGE = [
  ['object.align-left', 'Align left edges', AlignStartVertical],
  ['object.align-centre', 'Align horizontal centres', AlignCenterVertical],
  ['object.align-right', 'Align right edges', AlignEndVertical],
  ['object.align-top', 'Align top edges', AlignStartHorizontal],
  ['object.align-middle', 'Align vertical centres', AlignCenterHorizontal],
  ['object.align-bottom', 'Align bottom edges', AlignEndHorizontal],
  ['object.distribute-x', 'Distribute horizontally', AlignHorizontalDistributeCenter],
  ['object.distribute-y', 'Distribute vertically', AlignVerticalDistributeCenter],
] as const;

/** `3 asteroids, 1 mineral` */
function countsOf(objects: readonly FoundObject[]): string {
  const counts = new Map<ObjectKind, number>();
  for (const { kind } of objects) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return [...counts].map(([kind, count]) => plural(count, KINDS[kind].one, KINDS[kind].many)).join(', ');
}

/** Buttons for the selection. @param isFixed whether it contains only objects that every level has exactly once */
const Interactions = memo(function Interactions({
  isFixed,
  isLocked,
}: {
  readonly isFixed: boolean;
  readonly isLocked: boolean;
}) {
  const { commands } = useEditor();
  return (
    <span className="inspector__does">
      <Button
        hint="Bring into view"
        shortcut="Shift+2"
        icon={<Crosshair size={14} />}
        onClick={() => commands.run('view.fit-selection')}
      />
      <MarkButtons />
      {!isFixed && (
        <>
          <Button hint="Duplicate" icon={<CopyPlus size={14} />} onClick={() => commands.run('edit.duplicate')} />
          <Button hint="Delete" icon={<Trash2 size={14} />} disabled={isLocked} onClick={() => commands.run('edit.delete')} />
        </>
      )}
    </span>
  );
});

const Arrange = memo(function Arrange({ count }: { readonly count: number }) {
  const { commands } = useEditor();
  return (
    <Section title="Arrange">
      <div className="arrange" role="toolbar" aria-label="Arrange">
        {ARRANGE.map(([id, title, Icon]) => (
          <Button
            key={id}
            hint={title}
            icon={<Icon size={16} />}
            disabled={id.startsWith('object.distribute') && count < 3}
            onClick={() => commands.run(id)}
          />
        ))}
      </div>
    </Section>
  );
});

const NO_FACTS: readonly Fact[] = [];

/** What an object does in the shown run, updated while the level is edited. */
function RunFacts({ objectKey }: { readonly objectKey: string }) {
  const pick = useCallback(
    (proof: LiveProof) => {
      const found = objectsOf(proof.file).get(objectKey);
      return found === undefined ? NO_FACTS : runFactsOf(proof, found, radiusOf(found));
    },
    [objectKey],
  );
  return (
    <Section title="In the shown run">
      <Facts facts={useProofInPace(pick)} />
    </Section>
  );
}

interface ObjectFieldsProps {
  /** Stable between renders while the selection is the same. */
  readonly keys: readonly ObjectKey[];
  readonly objects: readonly FoundObject[];
}

/**
 * The fields of one object, or those that several have in common. Memoized, so that dragging hundreds of objects redraws
 * little.
 */
export function ObjectFields({ keys, objects }: ObjectFieldsProps) {
  const { document } = useLevel();
  const recipe = useCallback(
    (key: string, value: Field['fallback']) =>
      setObjectProperty(unlocked(document.file(), keys), key as FieldName, value as number | boolean | undefined),
    [document, keys],
  );
  const [first] = objects;
  const one = objects.length === 1;
  const isFixed = objects.every(({ list }) => list === null);
  const isLocked = objects.every((found) => marksOf(found).isLocked);
  const whose = one ? `of ${nameOf(first).toLowerCase()}` : `of ${objects.length} objects`;
  return (
    <>
      <Section
        title={one ? ownNameOf(first) : plural(objects.length, 'object')}
        aside={<Interactions isFixed={isFixed} isLocked={isLocked} />}
      >
        <p className="part__note">
          {one && ownNameOf(first) !== nameOf(first) && `${nameOf(first)}. `}
          {one ? aboutObject(first) : countsOf(objects)}
        </p>
        <MarkNotes objects={objects} />
        {one && <NameRow found={first} whose={whose} />}
        <fieldset className="inspector__fields" disabled={isLocked} aria-label="Fields">
          {sharedFields(objects.map(({ kind }) => kind)).map((field) => (
            <FieldRow key={field.key} field={field} {...valueOfObjects(objects, field)} whose={whose} recipe={recipe} />
          ))}
        </fieldset>
        {one && first.list !== null && (
          <p className="part__note numbers">
            id <code>{first.key}</code>
          </p>
        )}
      </Section>
      {!one && <Arrange count={objects.length} />}
      {!one && <TransformFields />}
      {one && <RunFacts objectKey={first.key} />}
    </>
  );
}

/** Turns the selection by typed degrees, scales it by a typed percentage, mirrors and repeats it. */
function TransformFields() {
  const editor = useEditor();
  const level = useLevel();
  const actions = useMemo(() => transformActions(level, objectChanges(editor, level)), [editor, level]);
  const [degrees, setDegrees] = useState(90);
  const [percent, setPercent] = useState(200);
  const [withRadii, setWithRadii] = useState(false);
  return (
    <Section title="Transform">
      <div className="transform">
        <NumberField label="turn °" value={degrees} min={-360} max={360} onChange={setDegrees} />
        <Button hint={`Turn by ${degrees}°`} icon={<RotateCw size={16} />} onClick={() => actions.turn(degrees)} />
        <NumberField label="scale %" value={percent} min={1} max={10_000} onChange={setPercent} />
        <Button
          hint={`Scale to ${percent} %`}
          icon={<Scaling size={16} />}
          onClick={() => actions.scale(percent / 100, withRadii)}
        />
      </div>
      <label className="setting--check">
        <input type="checkbox" checked={withRadii} onChange={(event) => setWithRadii(event.target.checked)} />
        Scale radii, too
      </label>
      <div className="transform__buttons" role="toolbar" aria-label="Transform">
        <Button
          hint="Mirror from left to right"
          shortcut="Shift+H"
          icon={<FlipHorizontal2 size={16} />}
          onClick={() => actions.mirror('x')}
        />
        <Button
          hint="Mirror from top to bottom"
          shortcut="Shift+V"
          icon={<FlipVertical2 size={16} />}
          onClick={() => actions.mirror('y')}
        />
        <Button hint="Repeat…" icon={<Grid3x3 size={16} />} onClick={() => editor.commands.run('object.repeat')} />
      </div>
    </Section>
  );
}

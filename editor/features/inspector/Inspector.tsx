import { memo, useDeferredValue } from 'react';
import type { LevelFile } from '../../../schema/index.ts';
import { useDocument, useSelectedKeys } from '../../core/context/index.ts';
import { type FoundObject, type ObjectKey, objectsOf } from '../../core/document/index.ts';
import { LevelFields } from './LevelFields.tsx';
import { ObjectFields } from './ObjectFields.tsx';
import './inspector.css';

/** The fields of the selection: one object, what several objects have in common, or the level itself. */
export function Inspector() {
  // A marquee changes the selection with every move of the pointer: the canvas has priority.
  const keys = useDeferredValue(useSelectedKeys());
  const file = useDocument((state) => state.file);
  return <Fields keys={keys} file={file} />;
}

const Fields = memo(function Fields({ keys, file }: { readonly keys: readonly ObjectKey[]; readonly file: LevelFile }) {
  const objects = keys.flatMap((key): FoundObject[] => {
    const found = objectsOf(file).get(key);
    return found === undefined ? [] : [found];
  });
  return (
    <div className="panel__body inspector">
      {/* Keyed by the selection, so that nothing typed for one object ends up in another. */}
      {objects.length === 0 ? <LevelFields file={file} /> : <ObjectFields key={keys.join()} keys={keys} objects={objects} />}
    </div>
  );
});

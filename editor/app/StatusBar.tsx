import { useStore } from 'zustand';
import { plural } from '../../check/words/index.ts';
import { useDocument, useEditor, usePageTerms, useProof, useProofInPace, useSession } from '../core/context/index.ts';
import { objectsOf } from '../core/document/index.ts';
import { endInWords, type LiveProof } from '../core/proof/index.ts';
import { FEATURES, useProblemCount } from '../features/index.ts';
import { AccuracySign } from './VerdictBadge.tsx';

const msOf = ({ ms }: LiveProof): string => ms.toFixed(1);

/** How long the last simulation took, throttled: figures that change with every frame can't be read. */
function ProofTime() {
  return useProofInPace(msOf);
}

/** The number of objects and problems, the view, and how the shown run ends. */
export function StatusBar() {
  const { settings } = useEditor();
  const objects = useDocument(({ file }) => objectsOf(file).size);
  const zoom = useSession((state) => state.zoom);
  const grid = useStore(settings, (state) => (state.snapToGrid ? `grid ${state.grid}` : 'grid off'));
  const { shown, folder } = usePageTerms();
  const problems = useProblemCount();
  const ends = useProof(endInWords);
  return (
    <footer className="statusbar numbers">
      <span>{plural(objects, 'object')}</span>
      <span>{problems === 0 ? 'no problems' : plural(problems, 'problem')}</span>
      <span>{grid}</span>
      <span>{Math.round(zoom * 100)} %</span>
      <span title={`gq check judges this folder at ${folder.accuracy.name}`}>
        {shown.accuracy.name}: <ProofTime /> ms
      </span>
      <AccuracySign />
      {FEATURES.map(({ name, status: Status }) => Status && <Status key={name} />)}
      <span>{ends}</span>
    </footer>
  );
}

import { Copy } from 'lucide-react';
import { useEditor, useProof, useProofInPace } from '../../context/index.ts';
import type { LiveProof } from '../../proof/index.ts';
import { copyText } from '../../share/index.ts';
import { Button } from '../../ui/index.ts';

/** ms between two updates: a hash covers every tick of the run */
const WAIT = 300;

const hashOf = ({ full }: LiveProof): string => full?.hash ?? '(work limit)';

/**
 * The hash of the shown run. It equals that of `gq simulate` at the same accuracy, in any browser, if the page computes the
 * same bits.
 */
export function RunHash() {
  const { notices } = useEditor();
  const hash = useProofInPace(hashOf, WAIT);
  const accuracy = useProof(({ terms }) => terms.accuracy.name);
  return (
    <p className="runs__hash">
      <span>hash</span>
      <output className="numbers" aria-label="Hash of the run" title={`gq simulate prints the same at --accuracy ${accuracy}`}>
        {hash}
      </output>
      <Button
        hint="Copy the hash of the run"
        icon={<Copy size={13} />}
        onClick={() => void copyText(notices, 'the hash of the run', hash)}
      />
    </p>
  );
}

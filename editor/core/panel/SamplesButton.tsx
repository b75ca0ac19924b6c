import { useEditor } from '../context/index.ts';
import { addSamples } from '../levels/index.ts';
import { Button } from '../ui/index.ts';

/** Offers the levels that come with the toolkit. */
export function SamplesButton() {
  const editor = useEditor();
  return (
    <Button
      hint="Levels that come with the toolkit, each with a run that completes it"
      look="outlined"
      onClick={() => void addSamples(editor, '')}
    >
      Add sample levels
    </Button>
  );
}

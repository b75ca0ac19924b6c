import { Undo2 } from 'lucide-react';
import { useEditor, usePageTerms } from '../core/context/index.ts';
import { isOtherAccuracy, termsInWords } from '../core/terms/index.ts';
import { Button } from '../core/ui/index.ts';

/**
 * Says so while the level is shown at another accuracy than that of the folder, and leads back to it.
 * @param isShort beside the verdict, where there is little room
 */
export function AccuracySign({ isShort = false }: { readonly isShort?: boolean }) {
  const { settings } = useEditor();
  const terms = usePageTerms();
  if (!isOtherAccuracy(terms)) return null;
  const { folder, shown } = terms;
  return (
    <Button
      hint={`The level is shown ${termsInWords(terms)}. Return to ${folder.accuracy.name}`}
      look="outlined"
      icon={<Undo2 size={13} />}
      onClick={() => settings.setState({ otherAccuracy: null })}
    >
      {isShort ? `at ${shown.accuracy.name}` : termsInWords(terms)}
    </Button>
  );
}

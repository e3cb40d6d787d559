using System.Buffers.Text;
using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>The words of a text, one after another, with their lines.</summary>
internal ref struct Words
{
    private const int MostShown = 40;
    private ReadOnlySpan<byte> _rest;
    private int _line = 1;

    /// <summary>The words of a file in UTF-8, or any other text whose keywords and numbers are ASCII.</summary>
    public Words(ReadOnlySpan<byte> text)
    {
        _rest = text.StartsWith("\uFEFF"u8) ? text[3..] : text;
    }

    public ReadOnlySpan<byte> Word { get; private set; }

    /// <summary>Its line.</summary>
    public readonly string Place => string.Create(CultureInfo.InvariantCulture, $"line {_line}");

    /// <summary>The word as it is shown in an error.</summary>
    public readonly string Shown => Word.IsEmpty
        ? _rest.IsEmpty ? "the end of the file" : "the end of the line"
        : Encoding.UTF8.GetString(Word[..Math.Min(Word.Length, MostShown)]) + (Word.Length > MostShown ? "…" : string.Empty);

    /// <summary>Goes to the next word of the file; false at its end.</summary>
    public bool Next() => Next(inLine: false);

    /// <summary>Goes to the next word of this line; a backslash at the end continues it on the next line.</summary>
    public bool NextInLine() => Next(inLine: true);

    /// <summary>Goes to the end of this line.</summary>
    public void SkipLine()
    {
        int end = _rest.IndexOf((byte)'\n');
        _rest = end < 0 ? default : _rest[end..];
        Word = default;
    }

    /// <summary>True if the word is a keyword, in letters of any size.</summary>
    public readonly bool Is(string keyword) => Ascii.EqualsIgnoreCase(Word, keyword);

    /// <summary>True if the word is a number, and nothing else.</summary>
    public readonly bool IsNumber(out double number) => Utf8Parser.TryParse(Word, out number, out int length) && length == Word.Length;

    private bool Next(bool inLine)
    {
        Word = default;
        while (_rest.Length > 0 && (IsBlank(_rest[0]) || Continues()))
        {
            if (_rest[0] == '\n')
            {
                if (inLine)
                    return false;

                _line++;
            }
            else if (_rest[0] == '\\')
            {
                _line++;
                _rest = _rest[_rest.IndexOf((byte)'\n')..];
            }

            _rest = _rest[1..];
        }

        int length = 0;
        while (length < _rest.Length && !IsBlank(_rest[length]))
            length++;

        Word = _rest[..length];
        _rest = _rest[length..];
        return length > 0;
    }

    private readonly bool Continues() => _rest[0] == '\\' && (_rest is [_, (byte)'\n', ..] || _rest is [_, (byte)'\r', (byte)'\n', ..]);

    private static bool IsBlank(byte letter) => letter is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' or (byte)'\f' or (byte)'\v';
}

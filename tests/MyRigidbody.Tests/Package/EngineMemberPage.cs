namespace RigidBodyDynamics.Tests.Package;

/// <summary>What stands above the table of docs/unity-members.md, in both languages.</summary>
internal static class EngineMemberPage
{
    public const string English = """
        # What the packages use of Unity

        [中文](unity-members.zh.md)

        Every member of the engine and of the editor that a script of the two packages names, with the version from which on it is there (2019.4: then or earlier) and the
        one that made it obsolete. What 2019.4 has not, and what a later version made obsolete, stands behind a symbol, nearly all of it in `EngineVersions.cs`; two are
        used though they are obsolete (a type's mark counts for its members), because nothing that every version has takes their place; a pragma says so there. A test
        writes the list (`MYRIGIDBODY_WRITE=1 dotnet test -c Release tests/MyRigidbody.Tests --filter EngineMember`) and fails where a member is new and nobody has looked its versions up.

        How it was checked: each name was looked up, public or protected and with its `Obsolete` attribute, in the C# sources that Unity publishes
        (`UnityCsReference`), in the newest of each of 23 minor versions from 2018.4 to 6000.7.0a1. All 268 of the engine and the editor are in every version from 2019.4,
        or from the one in the table, up to 6000.7; all but one (`SubsystemRegistration`, 2019.2) of those from 2019.4 are in 2018.4 too. The nine of the Input System were looked up in
        its 1.0.0 and 1.11.2. Whether an overload is obsolete was looked at where some were: `GetAssetPath` by number (6000.3), `ObjectField` without its last argument and
        `AddComponent` by a string; the scripts use none of them.

        Not checked: the types of parameters and results; what the members do ([stand-in.md](stand-in.md) has that); versions after 6000.7.0a1, among them 7.0;
        whatever an editor itself would say.

        | member | since | obsolete since |
        | --- | --- | --- |

        """;

    public const string Chinese = """
        # 两个包用到的 Unity 成员

        [English](unity-members.md)

        两个包的脚本用到的引擎和编辑器的全部成员，附有从哪个版本起有（2019.4：当时或更早），从哪个版本起过时。2019.4 没有的，以及后来的版本
        标为过时的，都写在条件编译符号之后，几乎都在 `EngineVersions.cs` 中；有两个虽已过时仍在使用（类型的标记也算它的成员），因为没有每个版本都有的代替者，那里用 pragma 说明。
        列表由测试写出（`MYRIGIDBODY_WRITE=1 dotnet test -c Release tests/MyRigidbody.Tests --filter EngineMember`）；有新成员而没有人查过它的版本时，测试失败。

        查法：在 Unity 公开的 C# 源码（`UnityCsReference`）中逐个查找名称，限于 public 或 protected，并看它的 `Obsolete` 特性，共看了从 2018.4 到 6000.7.0a1 的 23 个小版本，
        每个取最新的修订。引擎和编辑器的 268 个成员，从 2019.4 起（或从表中的版本起）到 6000.7 的每个版本都有；其中从 2019.4 起的，除一个（`SubsystemRegistration`，2019.2）外，
        2018.4 也有。Input System 的九个成员查的是它的 1.0.0 和 1.11.2。有过时重载的，还看了是哪个重载：按编号的 `GetAssetPath`（6000.3）、缺最后一个参数的 `ObjectField`、
        按字符串的 `AddComponent`；脚本都没有用。

        没有查的：参数和返回值的类型；成员的行为（见 [stand-in.zh.md](stand-in.zh.md)）；6000.7.0a1 之后的版本，包括 7.0；真正的编辑器自己会提示什么。

        | 成员 | 从何时起 | 从何时起过时 |
        | --- | --- | --- |

        """;
}

; The installer for one user, without an administrator: Inno Setup 6. Nobody has watched it run yet.
; build.py calls it with Version and Folder.

[Setup]
AppId={{6E1B5B0E-3B51-4F0D-9C53-0B1C8E0E7A51}
AppName=armui
AppVersion={#Version}
AppPublisher=The armui authors
DefaultDirName={localappdata}\Programs\armui
DefaultGroupName=armui
DisableProgramGroupPage=yes
PrivilegesRequired=lowest
ArchitecturesAllowed=x64compatible
ArchitecturesInstallIn64BitMode=x64compatible
MinVersion=10.0
OutputBaseFilename=armui-{#Version}-setup
Compression=lzma2
SolidCompression=yes
LicenseFile={#Folder}\licences\armui.txt
UninstallDisplayIcon={app}\armui-window.exe
; a running program is not ended by its update: it may be moving an arm
CloseApplications=no

[InstallDelete]
; nothing of an older version is loaded by a newer one; what the user keeps is elsewhere
Type: filesandordirs; Name: "{app}\_internal"

[Files]
Source: "{#Folder}\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion

[Icons]
Name: "{group}\armui"; Filename: "{app}\armui-window.exe"
Name: "{group}\armui (simulated arm)"; Filename: "{app}\armui-window.exe"; Parameters: "--sim"
Name: "{autodesktop}\armui"; Filename: "{app}\armui-window.exe"; Tasks: desktop

[Tasks]
Name: desktop; Description: "{cm:CreateDesktopIcon}"

[Run]
Filename: "{app}\armui-window.exe"; Description: "{cm:LaunchProgram,armui}"; Flags: nowait postinstall skipifsilent unchecked
